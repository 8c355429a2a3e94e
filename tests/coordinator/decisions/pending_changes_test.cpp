#include "coordinator/decisions/pending_changes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tetfarm {
namespace {

using testing::SizeIs;

TEST(PendingChanges, rows_are_taken_as_they_are_then_and_once) {
  DurableState rows;
  rows.jobs[JobId{1}].name = "wing";
  PendingChanges changes;
  changes.note(JobId{1});
  changes.note(JobId{1});
  rows.jobs[JobId{1}].name = "flange";
  const ChangeSet taken = changes.take(rows);
  ASSERT_THAT(taken.jobs, SizeIs(1));
  EXPECT_EQ(taken.jobs[0].name, "flange");
  EXPECT_TRUE(changes.take(rows).empty());
}

TEST(PendingChanges, attempts_workers_and_hosts_are_kept_as_told_last) {
  PendingChanges changes;
  AttemptRow attempt;
  attempt.id = AttemptId{3};
  changes.put(attempt);
  attempt.state = AttemptState::lost;
  changes.put(attempt);
  changes.put(WorkerRow{});
  changes.put(HostRow{});
  const ChangeSet taken = changes.take({});
  ASSERT_THAT(taken.attempts, SizeIs(1));
  EXPECT_EQ(taken.attempts[0].state, AttemptState::lost);
  EXPECT_THAT(taken.workers, SizeIs(1));
  EXPECT_THAT(taken.hosts, SizeIs(1));
}

TEST(PendingChanges, a_job_s_rows_are_pending_until_they_are_taken) {
  DurableState rows;
  rows.tasks[TaskId{1}] = {};
  PendingChanges changes;
  changes.put(AttemptRow{});
  EXPECT_TRUE(changes.has_no_job_rows());
  changes.note(TaskId{1});
  EXPECT_FALSE(changes.has_no_job_rows());
  changes.take(rows);
  EXPECT_TRUE(changes.has_no_job_rows());
}

}  // namespace
}  // namespace tetfarm
