#include "coordinator/decisions/file_needs.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "coordinator/decisions/finished_jobs.h"
#include "tests/coordinator/decisions/job_state_fixture.h"

namespace tetfarm {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::IsSubsetOf;
using testing::Not;

TaskRow task_in(TaskState state, TaskKind kind = TaskKind::mesh) {
  TaskRow task;
  task.id = TaskId{1};
  task.job = JobId{1};
  task.kind = kind;
  task.state = state;
  task.inputs = {fake_file("subdomain", "s")};
  return task;
}

TaskRow done_task(TaskKind kind) {
  TaskRow task = task_in(TaskState::done, kind);
  task.outputs = {fake_file("output", "o")};
  return task;
}

TEST(FileNeeds, a_task_that_is_still_to_run_needs_what_it_reads) {
  for (const TaskState state : {TaskState::waiting, TaskState::ready, TaskState::failed}) {
    EXPECT_TRUE(needs_inputs(task_in(state), FileStage::growing)) << name_of(state);
    EXPECT_FALSE(needs_inputs(task_in(state), FileStage::over)) << name_of(state);
  }
  for (const TaskState state : {TaskState::done, TaskState::replaced}) {
    EXPECT_FALSE(needs_inputs(task_in(state), FileStage::growing)) << name_of(state);
  }
  EXPECT_TRUE(needs_inputs(task_in(TaskState::leased), FileStage::over)) << "it reads it now";
  EXPECT_TRUE(needs_inputs(task_in(TaskState::done, TaskKind::inspect), FileStage::over))
      << "it came with the job";
  EXPECT_TRUE(needs_inputs(task_in(TaskState::done, TaskKind::solve), FileStage::over));
}

TEST(FileNeeds, what_a_kind_makes_waits_for_the_last_task_to_come_that_may_read_it) {
  const auto kinds_at = [](FileStage stage) {
    std::vector<std::string> names;
    for (const TaskKind kind : all_task_kinds) {
      if (may_get_readers(done_task(kind), stage)) names.emplace_back(name_of(kind));
    }
    return names;
  };
  EXPECT_THAT(kinds_at(FileStage::growing), Not(Contains("decompose")));
  EXPECT_EQ(kinds_at(FileStage::growing).size(), all_task_kinds.size() - 1);
  EXPECT_THAT(kinds_at(FileStage::numbered),
              ElementsAre("solve", "adapt", "collect", "remesh", "inspect", "number", "write",
                          "grow", "assemble"));
  const auto for_good = ElementsAre("solve", "adapt", "collect", "remesh", "inspect", "assemble");
  EXPECT_THAT(kinds_at(FileStage::assembling), for_good);
  EXPECT_THAT(kinds_at(FileStage::over), for_good);
}

TEST(FileNeeds, a_subdomain_may_be_cut_meshed_and_written_until_the_nodes_are_numbered) {
  SubdomainRow subdomain;
  for (const SubdomainState state : {SubdomainState::open, SubdomainState::leaf}) {
    subdomain.state = state;
    EXPECT_TRUE(may_get_readers(subdomain, FileStage::growing)) << name_of(state);
    EXPECT_FALSE(may_get_readers(subdomain, FileStage::numbered)) << name_of(state);
  }
  for (const SubdomainState state : {SubdomainState::cut, SubdomainState::joined}) {
    subdomain.state = state;
    EXPECT_FALSE(may_get_readers(subdomain, FileStage::growing)) << name_of(state);
  }
}

TEST(FileNeeds, a_file_that_two_tasks_read_stays_until_both_are_done) {
  FileNeeds needs;
  TaskRow first = task_in(TaskState::ready);
  TaskRow second = first;
  second.id = TaskId{2};
  second.job = JobId{2};
  needs.update(first, true, false);
  needs.update(second, true, false);
  needs.update(first, false, false);
  EXPECT_THAT(needs.take_unneeded(), IsEmpty());
  needs.update(second, false, false);
  EXPECT_THAT(needs.take_unneeded(), ElementsAre(first.inputs.front().hash));
  EXPECT_THAT(needs.take_unneeded(), IsEmpty()) << "it is said once";
}

TEST(FileNeeds, a_file_that_is_needed_again_before_it_is_taken_stays) {
  FileNeeds needs;
  const TaskRow task = task_in(TaskState::ready);
  needs.update(task, true, false);
  needs.update(task, false, false);
  needs.update(task, true, false);
  EXPECT_THAT(needs.take_unneeded(), IsEmpty());
}

TEST(FileNeeds, rows_that_leave_memory_leave_their_files) {
  FileNeeds needs;
  const TaskRow task = task_in(TaskState::ready);
  needs.update(task, true, false);
  needs.forget(task);
  EXPECT_THAT(needs.take_unneeded(), IsEmpty());
  EXPECT_FALSE(needs.is_needed(task.inputs.front().hash));
}

TEST(FileNeeds, evidence_of_a_failure_never_goes_but_what_a_replaced_task_made_does) {
  FileNeeds needs;
  TaskRow failed = task_in(TaskState::failed);
  failed.outputs = {fake_file("evidence", "e")};
  needs.update(failed, true, may_get_readers(failed, FileStage::growing));
  EXPECT_THAT(needs.take_unneeded(), IsEmpty());
  TaskRow replaced = task_in(TaskState::replaced);
  replaced.id = TaskId{2};
  replaced.outputs = {fake_file("mesh", "m")};
  replaced.numbers = {{"interior_nodes", 1}, {"tets", 1}};
  needs.update(replaced, false, may_get_readers(replaced, FileStage::growing));
  EXPECT_THAT(needs.take_unneeded(), ElementsAre(replaced.outputs.front().hash));
}

TEST(FileNeeds, of_finished_jobs_results_stay_and_all_where_they_may_go_on_or_keep_all) {
  DurableState rows;
  rows.jobs[JobId{1}].id = JobId{1};
  JobRow& job = rows.jobs.at(JobId{1});
  TaskRow mesh = done_task(TaskKind::mesh);
  TaskRow last = task_in(TaskState::done, TaskKind::assemble);
  last.id = TaskId{2};
  last.outputs = {fake_file("mesh.vtu", "r")};
  rows.tasks = {{mesh.id, mesh}, {last.id, last}};
  const std::string between = mesh.outputs.front().hash;
  const std::string result = last.outputs.front().hash;
  const FinishedJobs::Rows reader = {[&rows](JobId) { return rows; },
                                     [](TaskId) { return std::optional<TaskRow>(); }};
  FinishedJobs needed(reader, [](const JobRow&) { return false; });
  job.phase = JobPhase::cancelled;
  needed.put(rows);
  EXPECT_TRUE(needed.needs(between, {}));
  EXPECT_FALSE(needed.needs(between, {JobId{1}})) << "it goes on, and speaks for itself";
  job.phase = JobPhase::done;
  needed.put(rows);
  EXPECT_FALSE(needed.needs(between, {}));
  EXPECT_TRUE(needed.needs(result, {}));
  FinishedJobs all(reader, [](const JobRow&) { return true; });
  all.put(rows);
  EXPECT_TRUE(all.needs(between, {}));
}

TEST(FileNeeds, what_a_killed_coordinator_did_not_remove_is_found_at_the_next_start) {
  DurableState rows;
  rows.jobs[JobId{1}].id = JobId{1};
  rows.jobs.at(JobId{1}).phase = JobPhase::done;
  const TaskRow mesh = done_task(TaskKind::mesh);
  rows.tasks = {{mesh.id, mesh}};
  FinishedJobs finished(
      {[&rows](JobId) { return rows; }, [](TaskId) { return std::optional<TaskRow>(); }},
      [](const JobRow&) { return false; });
  DurableState unfinished;
  unfinished.jobs = rows.jobs;
  finished.put_others_than(unfinished, [](const ArtifactRef&) { return true; });
  EXPECT_THAT(finished.take_leavings(), ElementsAre(mesh.outputs.front().hash));
}

/// Removes what may go after each commit, as the coordinator does.
class FilesThatGoTest : public JobStateTest {
 protected:
  FilesThatGoTest() {
    rules_.keeps_all_files = [](const JobRow& job) { return job.key == "all"; };
    restart();
  }
  void remove_files() {
    commit();
    for (const std::string& hash : state_->take_unneeded_files()) {
      if (files_.erase(hash) > 0) gone_.insert(hash);
    }
  }
  /// Until a task of the kind is handed out, which is held.
  void run_until(TaskKind kind) {
    for (SendAssign assign = next(worker_); assign.attempt; assign = next(worker_)) {
      remove_files();
      held_ = assign;
      if (task(assign.task).kind == kind) return;
      ASSERT_TRUE(finish(worker_, assign));
      remove_files();
    }
    FAIL() << "there is no such task";
  }
  void run_to_the_end() {
    for (SendAssign assign = next(worker_); assign.attempt; assign = next(worker_)) {
      ASSERT_TRUE(finish(worker_, assign));
      remove_files();
    }
  }
  void begin(const std::string& key = "key") {
    submit(key);
    commit();
    worker_ = new_worker();
  }
  std::set<std::string> made_by_kind(TaskKind kind) const {
    std::set<std::string> hashes;
    for (const auto& [id, row] : state_->durable().tasks) {
      if (row.kind != kind) continue;
      for (const ArtifactRef& file : row.outputs) hashes.insert(file.hash);
    }
    return hashes;
  }
  std::size_t count_of(const char* what) const {
    std::size_t count = 0;
    for (const EventRow& event : record_.events()) count += event.what == what ? 1 : 0;
    return count;
  }

  std::set<std::string> gone_;
};

TEST_F(FilesThatGoTest, of_a_done_job_the_result_stays_what_it_came_with_and_its_inspection) {
  begin();
  run_to_the_end();
  ASSERT_EQ(job().phase, JobPhase::done);
  std::set<std::string> stay = made_by_kind(TaskKind::assemble);
  stay.merge(made_by_kind(TaskKind::inspect));
  stay.insert({job_file_.hash, surface_.hash});
  EXPECT_EQ(files_, stay);
  EXPECT_EQ(count_of("again"), 0U);
}

TEST_F(FilesThatGoTest, a_job_that_keeps_all_loses_none) {
  begin("all");
  run_to_the_end();
  ASSERT_EQ(job().phase, JobPhase::done);
  EXPECT_THAT(gone_, IsEmpty());
}

TEST_F(FilesThatGoTest, cut_subdomains_go_while_meshes_are_made_and_meshes_stay_till_written) {
  begin();
  run_until(TaskKind::order);
  EXPECT_THAT(gone_, Not(IsEmpty())) << "what was cut";
  EXPECT_THAT(gone_, IsSubsetOf(made_by_kind(TaskKind::decompose)));
  ASSERT_TRUE(finish(worker_, held_));
  run_until(TaskKind::number);
  for (const TaskKind kind : {TaskKind::mesh, TaskKind::extract, TaskKind::cosmetic}) {
    for (const std::string& file : made_by_kind(kind)) EXPECT_FALSE(gone_.contains(file));
  }
  ASSERT_TRUE(finish(worker_, held_));
  run_until(TaskKind::assemble);
  for (const TaskKind kind : {TaskKind::mesh, TaskKind::extract, TaskKind::cosmetic}) {
    EXPECT_THAT(made_by_kind(kind), IsSubsetOf(gone_)) << name_of(kind);
  }
  for (const std::string& file : made_by_kind(TaskKind::write)) EXPECT_TRUE(files_.contains(file));
}

TEST_F(FilesThatGoTest, a_damaged_portion_is_made_again_from_what_is_gone_down_to_the_job_itself) {
  begin();
  run_until(TaskKind::assemble);
  const std::string portion = *made_by_kind(TaskKind::write).begin();
  ASSERT_EQ(files_.erase(portion), 1U);
  TaskFailure damage;
  damage.cause = FailureCause::damaged_input;
  damage.damaged_inputs = {portion};
  ASSERT_TRUE(fail(worker_, held_, damage));
  for (int i = 0; i < 100 && job().phase == JobPhase::running; ++i) {
    wait(1000);
    run_to_the_end();
  }
  EXPECT_EQ(job().phase, JobPhase::done);
  EXPECT_GT(count_of("again"), 3U);
  const std::string outcome = outcome_of(JobId{1});
  EXPECT_THAT(files_, Not(Contains(portion))) << "it is gone again";
  submit("all");
  commit();
  run_to_the_end();
  EXPECT_EQ(outcome, outcome_of(JobId{2}));
}

TEST_F(FilesThatGoTest, a_job_that_keeps_all_is_not_robbed_by_another_with_the_same_files) {
  begin("all");
  run_until(TaskKind::number);
  const std::set<std::string> meshes = made_by_kind(TaskKind::mesh);
  submit("other");
  commit();
  remove_files();
  EXPECT_THAT(gone_, IsEmpty());
  ASSERT_TRUE(finish(worker_, held_));
  run_to_the_end();
  EXPECT_THAT(meshes, IsSubsetOf(files_));
}

TEST_F(FilesThatGoTest, what_an_attempt_brings_too_late_goes_when_it_speaks) {
  begin();
  run_until(TaskKind::mesh);
  const SendAssign late = held_;
  const WorkerId slow = worker_;
  state_->worker_left(slow, true, now_);
  now_.steady_ms += 60'000;
  worker_ = new_worker();
  run_to_the_end();
  ASSERT_EQ(job().phase, JobPhase::done);
  const TaskResult result = run_fake_task(task(late.task));
  files_.insert(result.outputs.front().hash);
  state_->done(add_worker({}), late.task, late.attempt, result, now_);
  state_->take_commands();
  remove_files();
  EXPECT_FALSE(files_.contains(result.outputs.front().hash));
}

TEST_F(FilesThatGoTest, a_new_start_finds_what_the_one_before_did_not_remove) {
  begin();
  run_until(TaskKind::assemble);
  const std::string mesh = *made_by_kind(TaskKind::mesh).begin();
  files_.insert(mesh);
  restart();
  EXPECT_THAT(state_->take_unneeded_files(), Contains(mesh));
}

}  // namespace
}  // namespace tetfarm
