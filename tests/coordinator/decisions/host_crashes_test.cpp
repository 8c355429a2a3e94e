#include "coordinator/decisions/host_crashes.h"

#include <gtest/gtest.h>

namespace tetfarm {
namespace {

TaskRow task_of(std::uint64_t number, std::uint64_t job) {
  TaskRow task;
  task.id = TaskId{number};
  task.job = JobId{job};
  return task;
}

bool all(TaskId) { return true; }

/// Crashed on "bad", and then done on "good".
void prove(HostCrashes& crashes, std::uint64_t task, std::uint64_t job) {
  crashes.note_crash("bad", task_of(task, job), "signal 11", all);
  EXPECT_EQ(crashes.note_done("good", TaskId{task}), "bad");
}

TEST(HostCrashes, a_task_that_was_done_elsewhere_speaks_against_the_host) {
  HostCrashes crashes;
  prove(crashes, 1, 1);
  prove(crashes, 2, 2);
  const auto proof = crashes.proof_against("bad", 2);
  ASSERT_TRUE(proof);
  EXPECT_EQ(proof->reason,
            "2 tasks of 2 jobs failed there and were done elsewhere; last failure: signal 11");
  EXPECT_FALSE(crashes.proof_against("bad", 3)) << "too few";
  EXPECT_FALSE(crashes.proof_against("good", 1));
}

TEST(HostCrashes, tasks_of_one_job_prove_nothing) {
  HostCrashes crashes;
  for (std::uint64_t task = 1; task <= 5; ++task) prove(crashes, task, 1);
  EXPECT_FALSE(crashes.proof_against("bad", 3));
}

TEST(HostCrashes, a_task_that_crashed_on_two_hosts_speaks_against_neither) {
  HostCrashes crashes;
  crashes.note_crash("bad", task_of(1, 1), "", all);
  crashes.note_crash("worse", task_of(1, 1), "", all);
  EXPECT_EQ(crashes.hosts_where_it_crashed(TaskId{1}), 2U);
  EXPECT_FALSE(crashes.note_done("good", TaskId{1}));
}

TEST(HostCrashes, a_host_that_does_a_task_starts_anew) {
  HostCrashes crashes;
  prove(crashes, 1, 1);
  prove(crashes, 2, 2);
  EXPECT_FALSE(crashes.note_done("bad", TaskId{3}));
  EXPECT_FALSE(crashes.proof_against("bad", 2));
  EXPECT_FALSE(crashes.crashed_on("bad", TaskId{1}));
}

TEST(HostCrashes, all_crashes_there_are_the_host_s_fault_also_those_of_tasks_that_are_not_done) {
  HostCrashes crashes;
  prove(crashes, 1, 1);
  prove(crashes, 2, 2);
  crashes.note_crash("bad", task_of(3, 3), "", all);
  crashes.note_crash("bad", task_of(3, 3), "", all);
  const auto proof = crashes.proof_against("bad", 2);
  ASSERT_TRUE(proof);
  EXPECT_EQ(proof->crashes.at(TaskId{3}), 2U);
  EXPECT_EQ(proof->crashes.at(TaskId{1}), 1U);
}

TEST(HostCrashes, tasks_of_jobs_that_are_over_are_forgotten_unless_they_prove_something) {
  HostCrashes crashes;
  prove(crashes, 1, 1);
  crashes.note_crash("bad", task_of(2, 2), "", all);
  crashes.note_crash("bad", task_of(3, 3), "", [](TaskId task) { return task == TaskId{3}; });
  EXPECT_TRUE(crashes.crashed_on("bad", TaskId{1}));
  EXPECT_FALSE(crashes.crashed_on("bad", TaskId{2}));
  EXPECT_TRUE(crashes.crashed_on("bad", TaskId{3}));
  EXPECT_TRUE(crashes.validate().empty());
}

}  // namespace
}  // namespace tetfarm
