#include "store/garbage.h"

#include <gmock/gmock.h>

#include <fstream>
#include <limits>
#include <map>

#include "base/file_system.h"
#include "base/hash.h"
#include "store/store_check.h"
#include "tests/base/temp_folder.h"

namespace tetfarm {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

constexpr std::int64_t nobody_runs = std::numeric_limits<std::int64_t>::max();

/// One job: inspect makes "root" of "surface", mesh makes "mesh" of "root", assemble "result" of
/// "mesh".
class StoreRows : public testing::Test {
 protected:
  StoreRows() {
    state_.jobs[JobId{1}].phase = JobPhase::done;
    add(1, TaskKind::inspect, "surface", "root");
    add(2, TaskKind::mesh, "root", "mesh");
    add(3, TaskKind::assemble, "mesh", "result");
  }
  ArtifactRef file(const std::string& name) const {
    return {name, hash128(name).hex(), name.size()};
  }
  void add(std::uint64_t id, TaskKind kind, const std::string& in, const std::string& out) {
    TaskRow& task = state_.tasks[TaskId{id}];
    task.id = TaskId{id};
    task.job = JobId{1};
    task.kind = kind;
    task.state = TaskState::done;
    task.inputs = {file(in)};
    task.outputs = {file(out)};
    store_.publish(in);
    store_.publish(out);
  }
  std::set<std::string> kept(bool all_finished) const {
    std::set<std::string> names;
    const std::set<std::string> needed = needed_files(state_, all_finished);
    for (const char* name : {"surface", "root", "mesh", "result"}) {
      if (needed.contains(hash128(name).hex())) names.insert(name);
    }
    return names;
  }
  StoreReport check() const { return check_store(state_, look_into(store_, true)); }
  void break_file(const std::string& name) const {
    write_file_atomically(store_.path_of(file(name).hash), std::string(name.size(), 'x'));
  }

  TempFolder folder_;
  ArtifactStore store_{folder_.path()};
  DurableState state_;
};

TEST_F(StoreRows, a_done_job_needs_its_ends_and_unless_told_otherwise_its_middle) {
  EXPECT_THAT(kept(false), UnorderedElementsAre("surface", "root", "mesh", "result"));
  EXPECT_THAT(kept(true), UnorderedElementsAre("surface", "result"));
  state_.jobs[JobId{1}].phase = JobPhase::running;
  EXPECT_THAT(kept(true), UnorderedElementsAre("surface", "root", "mesh", "result"));
  state_.jobs[JobId{1}].phase = JobPhase::failed;
  EXPECT_THAT(kept(true), UnorderedElementsAre("surface", "root", "mesh", "result"));
  state_.jobs[JobId{1}].phase = JobPhase::cancelled;
  EXPECT_THAT(kept(false), IsEmpty());
}

TEST_F(StoreRows, what_was_replaced_needs_nothing) {
  state_.jobs[JobId{1}].phase = JobPhase::running;
  state_.tasks[TaskId{2}].state = TaskState::replaced;
  state_.tasks[TaskId{3}].inputs = {};
  EXPECT_THAT(kept(false), UnorderedElementsAre("surface", "root", "result"));
  break_file("mesh");
  EXPECT_THAT(check().damaged, IsEmpty());
}

TEST_F(StoreRows, removes_what_is_not_needed_and_nothing_else) {
  const auto leftover = store_.publish("of an attempt that came too late");
  write_file_atomically(store_.scratch_path("half"), "half a file");
  store_.set_aside(file("root").hash);
  write_file_atomically(store_.path_of(file("mesh").hash).string() + ".1.ab.tmp", "unfinished");
  const Garbage garbage = find_garbage(store_, needed_files(state_, false), nobody_runs);
  EXPECT_EQ(garbage.files.size(), 4U);
  remove_garbage(store_, garbage);
  EXPECT_FALSE(store_.has(leftover.hash, leftover.size));
  EXPECT_EQ(count_files(store_.folder()), 4U) << "three artifacts and the store's id";
  EXPECT_FALSE(std::filesystem::exists(store_.folder() / "damaged"));
  EXPECT_THAT(find_garbage(store_, needed_files(state_, false), nobody_runs).files, IsEmpty());
}

TEST_F(StoreRows, what_a_running_attempt_may_be_writing_stays) {
  store_.publish("being made");
  AttemptRow attempt;
  attempt.started_ms = 5'000'000;
  state_.running_attempts[AttemptId{1}] = attempt;
  const std::int64_t since = untouchable_since_ms(state_);
  EXPECT_LT(since, attempt.started_ms) << "clocks differ";
  const Garbage garbage = find_garbage(store_, needed_files(state_, false), since);
  EXPECT_THAT(garbage.files, IsEmpty());
  EXPECT_EQ(garbage.too_young, 1U);
}

TEST_F(StoreRows, a_sound_store_has_nothing_to_redo) {
  const StoreReport report = check();
  EXPECT_EQ(report.files, 4U);
  EXPECT_THAT(report.damaged, IsEmpty());
  EXPECT_THAT(report.redone, IsEmpty());
}

TEST_F(StoreRows, what_is_damaged_in_the_middle_of_a_done_job_is_redone_only_with_its_result) {
  break_file("mesh");
  EXPECT_EQ(check().damaged.at(0).state, FileState::wrong_bytes);
  EXPECT_FALSE(check().damaged.at(0).is_needed);
  EXPECT_THAT(check().redone, IsEmpty());
  remove_file(store_.path_of(file("result").hash));
  EXPECT_THAT(check().redone, ElementsAre(TaskId{2}, TaskId{3}));
}

TEST_F(StoreRows, what_was_removed_as_all_had_read_it_is_counted_and_not_damaged) {
  remove_file(store_.path_of(file("mesh").hash));
  EXPECT_EQ(check().damaged.size(), 1U) << "its job keeps all";
  const auto check_needed = [this] {
    return check_store(state_, look_into(store_, true), [](const JobRow&) { return false; });
  };
  EXPECT_THAT(check_needed().damaged, IsEmpty());
  EXPECT_EQ(check_needed().gone, 1U);
  state_.jobs[JobId{1}].phase = JobPhase::running;
  state_.tasks[TaskId{3}].state = TaskState::ready;
  EXPECT_EQ(check_needed().gone, 0U) << "a task is to read it";
  EXPECT_EQ(check_needed().damaged.size(), 1U);
}

TEST_F(StoreRows, a_running_job_redoes_what_its_next_tasks_read) {
  state_.jobs[JobId{1}].phase = JobPhase::running;
  state_.tasks[TaskId{3}].state = TaskState::ready;
  write_file_atomically(store_.path_of(file("mesh").hash), "cut");
  EXPECT_EQ(check().damaged.at(0).state, FileState::wrong_size);
  EXPECT_THAT(check().redone, ElementsAre(TaskId{2}));
  break_file("surface");
  EXPECT_THAT(check().hopeless, IsEmpty()) << "nothing reads it again";
  remove_file(store_.path_of(file("root").hash));
  EXPECT_THAT(check().redone, ElementsAre(TaskId{1}, TaskId{2}));
  EXPECT_THAT(check().hopeless, ElementsAre(JobId{1})) << "the root's maker needs it";
}

TEST_F(StoreRows, what_is_garbage_is_counted_listed_and_told_from_what_may_be_growing) {
  std::filesystem::create_directories(folder_.path() / "damaged");
  std::ofstream(folder_.path() / "damaged/one") << "12345";
  std::ofstream(store_.scratch_folder() / "growing") << "123";
  const std::set<std::string> needed = needed_files(state_, true);
  const Garbage all = find_garbage(store_, needed, nobody_runs);
  // "root" and "mesh" lie between; with the two others that is everything.
  EXPECT_EQ(all.bytes, 4U + 4U + 5U + 3U);
  std::vector<std::filesystem::path> expected = {
      store_.path_of(file("root").hash), store_.path_of(file("mesh").hash),
      folder_.path() / "damaged/one", store_.scratch_folder() / "growing"};
  std::sort(expected.begin(), expected.end());
  EXPECT_EQ(all.files, expected);
  EXPECT_EQ(all.too_young, 0U);
  const Garbage young = find_garbage(store_, needed, 0);
  EXPECT_TRUE(young.files.empty());
  EXPECT_EQ(young.bytes, 0U);
  EXPECT_EQ(young.too_young, 4U);
  remove_garbage(store_, all);
  for (const auto& path : expected) EXPECT_FALSE(std::filesystem::exists(path)) << path;
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "damaged")) << "it is empty";
  EXPECT_TRUE(std::filesystem::exists(store_.scratch_folder()));
  EXPECT_TRUE(store_.has(file("surface").hash, 7));
  EXPECT_TRUE(store_.has(file("result").hash, 6));
}

TEST_F(StoreRows, nothing_is_removed_that_was_touched_ten_minutes_before_the_oldest_attempt) {
  EXPECT_EQ(untouchable_since_ms(state_), nobody_runs);
  state_.running_attempts[AttemptId{1}].started_ms = 2'000'000;
  state_.running_attempts[AttemptId{2}].started_ms = 1'000'000;
  EXPECT_EQ(untouchable_since_ms(state_), 400'000);
}

TEST_F(StoreRows, of_cancelled_and_failed_jobs_is_needed_what_they_can_go_on_with) {
  state_.jobs[JobId{1}].phase = JobPhase::cancelled;
  EXPECT_THAT(kept(false), IsEmpty());
  state_.jobs[JobId{1}].phase = JobPhase::failed;
  EXPECT_THAT(kept(true), UnorderedElementsAre("surface", "root", "mesh", "result"));
  state_.jobs[JobId{1}].phase = JobPhase::running;
  EXPECT_THAT(kept(true), UnorderedElementsAre("surface", "root", "mesh", "result"));
}

TEST_F(StoreRows, are_compared_with_every_file_once_and_what_is_wrong_is_told) {
  break_file("root");
  write_file_atomically(store_.path_of(file("mesh").hash), "longer than before");
  std::filesystem::remove(store_.path_of(file("result").hash));
  const StoreReport report = check();
  EXPECT_EQ(report.files, 4U);
  std::map<std::string, std::string> found;
  for (const DamagedFile& damaged : report.damaged) {
    found[damaged.file.name] = std::string(name_of(damaged.state)) +
                               (damaged.is_needed ? ", needed" : "") + ", made by " +
                               std::to_string(damaged.makers.at(0).value);
  }
  EXPECT_THAT(
      found, UnorderedElementsAre(testing::Pair("root", "with a wrong checksum, needed, made by 1"),
                                  testing::Pair("mesh", "of another size, needed, made by 2"),
                                  testing::Pair("result", "missing, needed, made by 3")));
  EXPECT_THAT(report.redone, ElementsAre(TaskId{1}, TaskId{2}, TaskId{3}));
  EXPECT_THAT(report.hopeless, IsEmpty());
  const StoreReport sizes = check_store(state_, look_into(store_, false));
  EXPECT_EQ(sizes.damaged.size(), 2U) << "of a wrong checksum a look at the size tells nothing";
  EXPECT_STREQ(name_of(FileState::sound), "sound");
}

TEST_F(StoreRows, of_which_the_input_of_a_job_is_gone_are_hopeless_only_where_it_is_needed) {
  break_file("surface");
  EXPECT_THAT(check().hopeless, IsEmpty()) << "the job has its result";
  break_file("result");
  break_file("mesh");
  break_file("root");
  const StoreReport report = check();
  EXPECT_THAT(report.hopeless, ElementsAre(JobId{1}));
  EXPECT_THAT(report.redone, ElementsAre(TaskId{1}, TaskId{2}, TaskId{3}));
}

}  // namespace
}  // namespace tetfarm
