#include "cli/seen_times.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/file_system.h"
#include "store/artifact_store.h"
#include "store/job_database.h"
#include "tests/base/temp_folder.h"

namespace tetfarm {
namespace {

TEST(SeenTimes, a_range_has_two_digits_and_a_unit_that_suits) {
  EXPECT_EQ(range_text(19.8, 91), "20 to 91 s");
  EXPECT_EQ(range_text(0.123, 0.47), "0.12 to 0.47 s");
  EXPECT_EQ(range_text(123, 456), "120 to 460 s");
  EXPECT_EQ(range_text(66, 1200), "1.1 to 20 min");
  EXPECT_EQ(range_text(3600, 36000), "1 to 10 h");
  EXPECT_EQ(range_text(9.96, 100), "10 to 100 s");
  EXPECT_EQ(range_text(0, 0), "0 s");
}

TEST(SeenTimes, ends_that_read_the_same_are_one_number) {
  EXPECT_EQ(range_text(2.01, 2.04), "2 s");
}

TEST(SeenTimes, without_a_store_nothing_is_learnt) {
  EXPECT_EQ(times_seen_in("", "").learnt(), 0U);
}

TEST(SeenTimes, a_folder_that_is_no_store_is_not_found) {
  const TempFolder folder;
  try {
    times_seen_in(folder.path().string(), "");
    FAIL() << "took an empty folder for a store";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::not_found);
    EXPECT_EQ(error.what(), "\"" + folder.path().string() +
                                "\" is neither a store nor the output folder of a run");
  }
}

TEST(SeenTimes, hours_and_minutes_begin_when_there_are_some_of_them) {
  EXPECT_EQ(range_text(1, 599), "1 to 600 s");
  EXPECT_EQ(range_text(60, 600), "1 to 10 min");
  EXPECT_EQ(range_text(3600, 3 * 3600 - 40), "60 to 180 min");
  EXPECT_EQ(range_text(3600, 3 * 3600), "1 to 3 h");
}

TaskRow timed_task(std::uint64_t id) {
  TaskRow task;
  task.id = TaskId{id};
  task.job = JobId{1};
  task.kind = TaskKind::mesh;
  task.path = id;
  task.state = TaskState::done;
  task.attempt = AttemptId{id};
  task.numbers = {
      {"cpu_seconds", 2}, {"size_elements", 1000}, {"size_triangles", 20}, {"size_needles", 3}};
  return task;
}

/// A run with these tasks; its database may lie elsewhere.
class TimesOfARun : public ::testing::Test {
 protected:
  void apply(const std::vector<TaskRow>& tasks, const std::filesystem::path& database) const {
    ChangeSet changes;
    JobRow job;
    job.id = JobId{1};
    changes.jobs = {job};
    changes.tasks = tasks;
    JobDatabase(database / "tetfarm.db").apply(changes);
  }

  const TempFolder folder_;
  ArtifactStore store_{folder_.path() / "out" / ".tetfarm"};
};

TEST_F(TimesOfARun, are_learnt_from_tasks_that_are_done_and_tell_size_and_time) {
  TaskRow failed = timed_task(3);
  failed.state = TaskState::failed;
  TaskRow without_time = timed_task(4);
  without_time.numbers.erase("cpu_seconds");
  TaskRow without_size = timed_task(5);
  without_size.numbers.erase("size_elements");
  apply({timed_task(1), timed_task(2), failed, without_time, without_size}, store_.folder());
  EXPECT_EQ(times_seen_in(store_.folder().string(), "").learnt(), 2U);
  const TaskTimes times = times_seen_in((folder_.path() / "out").string(), "");
  EXPECT_EQ(times.learnt(), 2U) << "of the folder of the run";
  TaskTimes expected;
  for (int i = 0; i < 2; ++i) expected.learn(TaskKind::mesh, {1000, 20, 3}, 2);
  EXPECT_EQ(times.seconds(TaskKind::mesh, {500, 70, 9}).expected,
            expected.seconds(TaskKind::mesh, {500, 70, 9}).expected);
}

TEST_F(TimesOfARun, are_learnt_from_as_many_tasks_as_there_are) {
  std::vector<TaskRow> tasks;
  for (std::uint64_t id = 1; id <= 1001; ++id) tasks.push_back(timed_task(id));
  tasks.back().kind = TaskKind::write;  // so many are kept of a kind
  apply(tasks, store_.folder());
  EXPECT_EQ(times_seen_in(store_.folder().string(), "").learnt(), 1001U);
}

TEST_F(TimesOfARun, are_read_where_the_database_is) {
  const std::filesystem::path elsewhere = folder_.path() / "database";
  make_folders(elsewhere);
  apply({timed_task(1)}, elsewhere);
  EXPECT_EQ(times_seen_in(store_.folder().string(), elsewhere.string()).learnt(), 1U);
  EXPECT_THROW(times_seen_in(store_.folder().string(), ""), IoError);
}

}  // namespace
}  // namespace tetfarm
