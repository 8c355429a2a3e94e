#include "coordinator/space_watch.h"

#include <gtest/gtest.h>

#include "store/disk_room.h"

namespace tetfarm {
namespace {

class ExpectedBytes : public testing::Test {
 protected:
  ExpectedBytes() { state_.jobs[JobId{1}].id = JobId{1}; }
  TaskRow& add(TaskKind kind, TaskState state, std::uint64_t in, std::uint64_t out) {
    const TaskId id{state_.tasks.size() + 1};
    TaskRow& task = state_.tasks[id];
    task.id = id;
    task.job = JobId{1};
    task.kind = kind;
    task.state = state;
    task.inputs = {{"in", "", in}};
    if (out > 0) task.outputs = {{"out", "", out}};
    if (state == TaskState::leased) {
      AttemptRow& attempt = state_.running_attempts[AttemptId{id.value}];
      attempt.id = task.attempt = AttemptId{id.value};
      attempt.task = id;
    }
    return task;
  }
  std::uint64_t expected_bytes(std::size_t workers) const {
    SpaceWatch watch("", "");
    for (const auto& [id, task] : state_.tasks) watch.note(task);
    const JobState state(state_, {}, [](const ArtifactRef&) { return true; }, {});
    return watch.expected_bytes(state, workers);
  }
  DurableState state_;
};

TEST_F(ExpectedBytes, are_those_of_the_largest_of_its_kind) {
  add(TaskKind::decompose, TaskState::done, 10, 100);
  add(TaskKind::decompose, TaskState::done, 10, 300);
  add(TaskKind::decompose, TaskState::done, 10, 200);
  EXPECT_EQ(expected_bytes(5), 0U) << "nothing runs";
  add(TaskKind::decompose, TaskState::leased, 10, 0);
  EXPECT_EQ(expected_bytes(5), 300U);
}

TEST_F(ExpectedBytes, of_the_first_of_a_kind_are_twice_what_it_reads_or_follow_its_elements) {
  add(TaskKind::extract, TaskState::leased, 50, 0);
  EXPECT_EQ(expected_bytes(0), 100U);
  add(TaskKind::mesh, TaskState::leased, 50, 0).parameters["work"] = "1000";
  EXPECT_EQ(expected_bytes(0), 20'100U);
}

TEST_F(ExpectedBytes, of_assemble_are_as_many_as_it_reads) {
  add(TaskKind::assemble, TaskState::leased, 50, 0);
  EXPECT_EQ(expected_bytes(0), 50U);
}

TEST_F(ExpectedBytes, of_ready_tasks_count_for_as_many_as_there_are_workers) {
  for (int i = 0; i < 5; ++i) add(TaskKind::extract, TaskState::ready, 50, 0);
  EXPECT_EQ(expected_bytes(2), 200U);
  state_.jobs[JobId{1}].phase = JobPhase::cancelled;
  EXPECT_EQ(expected_bytes(2), 0U);
}

class Room : public ExpectedBytes {
 protected:
  std::string trouble(Moment now = {.steady_ms = 1000}) {
    const JobState state(state_, {}, [](const ArtifactRef&) { return true; }, {});
    return watch_.trouble(state, now);
  }
  static constexpr std::uint64_t mib = std::uint64_t{1} << 20U;
  std::uint64_t free_for_store_ = 1000 * mib;
  std::uint64_t free_for_database_ = 1000 * mib;
  SpaceWatch watch_{"store", "database", [this](const std::filesystem::path& path) {
                      const bool is_store = path == "store";
                      return DiskRoom{.free_bytes = is_store ? free_for_store_ : free_for_database_,
                                      .total_bytes = 10'000 * mib};
                    }};
};

TEST_F(Room, of_both_disks_is_enough_to_go_on) {
  add(TaskKind::extract, TaskState::leased, 400 * mib, 0);
  EXPECT_EQ(trouble(), "");
}

TEST_F(Room, on_the_disk_of_the_store_is_for_what_comes_and_a_reserve) {
  add(TaskKind::extract, TaskState::leased, 400 * mib, 0);
  free_for_store_ = 863 * mib;
  EXPECT_EQ(
      trouble(),
      "store: 863 MiB free, 800 MiB needed for what runs and comes next, 64 MiB kept in reserve");
}

TEST_F(Room, on_the_disk_of_the_database_is_the_reserve_whatever_the_store_has) {
  add(TaskKind::extract, TaskState::leased, 400 * mib, 0);
  free_for_database_ = 64 * mib;
  EXPECT_EQ(trouble(), "");
  free_for_database_ -= 1;
  EXPECT_EQ(trouble({.steady_ms = 2000}), "database: 63 MiB free for the database");
}

TEST_F(Room, is_no_trouble_where_nothing_is_to_be_written) {
  free_for_store_ = free_for_database_ = 0;
  EXPECT_EQ(trouble(), "");
}

TEST_F(Room, is_looked_at_twice_a_second_at_most) {
  add(TaskKind::extract, TaskState::leased, 400 * mib, 0);
  EXPECT_EQ(trouble({.steady_ms = 1000}), "");
  free_for_store_ = 0;
  EXPECT_EQ(trouble({.steady_ms = 1499}), "");
  EXPECT_NE(trouble({.steady_ms = 1500}), "");
}

TEST(DiskRoom, keeps_some_back_but_of_a_small_disk_little) {
  const DiskRoom small{.free_bytes = 500, .total_bytes = 2000};
  EXPECT_TRUE(small.has(400));
  EXPECT_FALSE(small.has(401));
  const DiskRoom large{.free_bytes = std::uint64_t{100} << 20U,
                       .total_bytes = std::uint64_t{1} << 40U};
  EXPECT_TRUE(large.has(std::uint64_t{36} << 20U));
  EXPECT_FALSE(large.has(std::uint64_t{37} << 20U));
  EXPECT_TRUE((DiskRoom{.free_bytes = 0, .total_bytes = 0}).has(1)) << "nothing is known";
  EXPECT_GT(disk_room("/tmp/not there yet/nor this").total_bytes, 0U);
}

}  // namespace
}  // namespace tetfarm
