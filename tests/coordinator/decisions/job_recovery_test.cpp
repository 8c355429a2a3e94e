// What the simulated farm has found (farm_schedules.h), each as a few events.
#include <algorithm>

#include "tasks/failure_cause.h"
#include "tests/coordinator/decisions/job_state_fixture.h"

namespace tetfarm {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

class Recovery : public JobStateTest {
 protected:
  bool is_on_record(const std::string& what) {
    const std::vector<EventRow> events = state_->take_changes().events;
    return std::any_of(events.begin(), events.end(),
                       [&what](const EventRow& event) { return event.what == what; });
  }
};

TEST_F(Recovery, a_process_on_a_new_connection_gets_the_assignment_that_was_lost) {
  submit();
  const SendAssign lost = next(add_worker({.nonce = "one"}));
  const WorkerId again = add_worker({.nonce = "one"});
  EXPECT_EQ(state_->worker_count(), 1U) << "its old connection would still be given tasks";
  const SendAssign said_again = next(again);
  EXPECT_EQ(said_again.attempt, lost.attempt);
  EXPECT_TRUE(finish(again, said_again));
  EXPECT_EQ(task(lost.task).losses, 0U);
}

TEST_F(Recovery, a_missing_input_is_told_with_the_task_that_makes_it_and_how_that_stands) {
  submit();
  worker_ = add_worker({.nonce = "one"});
  run_until_meshes();
  TaskFailure killed;
  killed.cause = FailureCause::killed;
  ASSERT_TRUE(fail(worker_, held_, killed));
  now_.steady_ms += 1000;
  const ArtifactRef lost = task(held_.task).inputs.front();
  files_.erase(lost.hash);
  const std::vector<std::string> why = state_->outlook(held_.task, now_).reasons;
  ASSERT_FALSE(why.empty());
  EXPECT_THAT(why.front(), HasSubstr("its input '" + lost.name + "' is not in the store"));
  EXPECT_THAT(why.front(), testing::MatchesRegex(".*; task [0-9]+, .*, makes it .done."));
}

TEST_F(Recovery, an_assignment_that_was_committed_and_never_said_is_said_after_a_restart) {
  submit();
  const SendAssign lost = next(add_worker({.nonce = "one"}));
  restart();
  EXPECT_EQ(next(add_worker({.nonce = "one"})).attempt, lost.attempt);
}

TEST_F(Recovery, a_process_that_left_a_connection_idle_is_not_given_tasks_there) {
  const WorkerId old = add_worker({.nonce = "one"});
  state_->worker_is_ready(old, now_);
  const WorkerId current = add_worker({.nonce = "one"});
  submit();
  EXPECT_FALSE(state_->knows_worker(old));
  EXPECT_TRUE(next(current).attempt);
}

TEST_F(Recovery, what_no_record_may_say_of_a_task_is_a_broken_invariant) {
  submit();
  worker_ = new_worker();
  const SendAssign inspect = next(worker_);
  ASSERT_TRUE(finish(worker_, inspect));
  EXPECT_THAT(state_->validate(), IsEmpty());
  DurableState by_nobody = record_.state();
  by_nobody.tasks.at(inspect.task).attempt = {};
  const JobState anew(
      by_nobody, rules_, [this](const ArtifactRef& file) { return files_.contains(file.hash); },
      now_);
  EXPECT_THAT(anew.validate(), testing::ElementsAre("task " + std::to_string(inspect.task.value) +
                                                    ": done by nobody"));
}

TEST_F(Recovery, what_a_start_decides_is_recorded_though_the_disk_was_full) {
  submit();
  worker_ = new_worker();
  const SendAssign inspect = next(worker_);
  ASSERT_TRUE(finish(worker_, inspect));
  const std::vector<ArtifactRef> made = task(inspect.task).outputs;
  for (const ArtifactRef& file : made) files_.erase(file.hash);
  next(worker_);  // the next task starts to wait, and its makers run again
  const ChangeSet nothing = state_->take_changes();
  ASSERT_TRUE(nothing.tasks.empty());
  // The maker's row as it was before: the commit that made it ready failed.
  DurableState before = record_.state();
  TaskRow& maker = before.tasks.at(inspect.task);
  maker.state = TaskState::done;
  maker.attempt = inspect.attempt;
  JobState anew(
      before, rules_, [this](const ArtifactRef& file) { return files_.contains(file.hash); }, now_);
  anew.hold_back("no room", now_);
  const std::vector<TaskRow> changed = anew.take_changes().tasks;
  EXPECT_TRUE(std::any_of(changed.begin(), changed.end(), [&](const TaskRow& row) {
    return row.id == inspect.task && row.state == TaskState::ready;
  }));
  EXPECT_TRUE(anew.is_stuck());
}

TEST_F(Recovery, a_full_disk_is_recorded_once_by_the_task_that_found_it_and_never_by_a_commit) {
  EXPECT_TRUE(state_->hold_back("no room", now_));
  EXPECT_FALSE(is_on_record("stuck")) << "it would have to be committed to the full disk";
  restart();
  state_->out_of_resources("no room", now_);
  EXPECT_TRUE(is_on_record("stuck"));
  state_->out_of_resources("no room", now_);
  EXPECT_FALSE(is_on_record("stuck"));
}

TEST_F(Recovery, two_attempts_of_one_task_may_run_out_of_their_leases_at_once) {
  rules_.max_losses = 1;
  rules_.least_late_ms = 1;
  restart();
  run_job(2, 0);
  // A second run of the same kind is expected to take no time, and is raced at once.
  const ArtifactRef other = fake_job(3, 0);
  files_.insert(other.hash);
  state_->worker_left(worker_, false, now_);
  state_->submit({"other", "wing", "toml", to_inspect(other, surface_)}, now_);
  const SendAssign first = next(add_worker({.host = "a", .nonce = "a"}));
  now_.steady_ms += rules_.lease_ms / 2;
  const SendAssign second = next(add_worker({.host = "b", .nonce = "b"}));
  ASSERT_EQ(first.task, second.task);
  now_.steady_ms += 2 * rules_.lease_ms;
  state_->tick(now_);
  EXPECT_EQ(task(first.task).state, TaskState::failed);
  EXPECT_THAT(state_->validate(), IsEmpty());
}

TEST_F(Recovery, a_job_goes_on_with_what_a_task_made_before_it_came_into_quarantine) {
  rules_.max_crashes = 1;
  restart();
  submit();
  worker_ = add_worker({.nonce = "one"});
  const auto turns_left = [this] {
    std::size_t done = 0;
    for (const auto& [id, row] : state_->durable().tasks) {
      if (row.kind == TaskKind::cosmetic && row.state == TaskState::done) ++done;
    }
    return tasks(JobId{1}, TaskKind::extract) - done;
  };
  SendAssign last = next(worker_);
  while (task(last.task).kind != TaskKind::cosmetic || turns_left() > 2) {
    ASSERT_TRUE(finish(worker_, last));
    last = next(worker_);
  }
  // A file for the turn before the last is lost, and making it again fails.
  const WorkerId other = add_worker({.host = "other", .nonce = "other"});
  const SendAssign turn = next(other);
  ASSERT_EQ(task(turn.task).kind, TaskKind::cosmetic);
  const std::string lost = task(turn.task).inputs.back().hash;
  files_.erase(lost);
  TaskFailure damaged = crash();
  damaged.cause = FailureCause::damaged_input;
  damaged.damaged_inputs = {lost};
  ASSERT_TRUE(fail(other, turn, damaged));
  const SendAssign maker = next(other);
  ASSERT_TRUE(fail(other, maker, {}));
  ASSERT_EQ(task(maker.task).state, TaskState::failed);
  ASSERT_EQ(task(turn.task).state, TaskState::waiting);
  // Somebody brings the file back.
  files_.insert(lost);
  restart();
  worker_ = add_worker({.nonce = "one"});
  ASSERT_EQ(next(worker_).attempt, last.attempt);
  ASSERT_TRUE(finish(worker_, last));
  run_all();
  EXPECT_EQ(job().phase, JobPhase::done) << job().message;
}

}  // namespace
}  // namespace tetfarm
