#include "coordinator/views/running_tasks.h"

#include <gtest/gtest.h>

#include "coordinator/views/query_answers.h"
#include "tests/coordinator/decisions/job_state_fixture.h"

namespace tetfarm {
namespace {

class RunningTasks : public JobStateTest {
 protected:
  RunningTasks() {
    submit();
    commit();
    worker_ = new_worker();
    assign_ = next(worker_);
  }
  void say(const WorkCount& count) {
    state_->note_work(worker_, assign_.task, assign_.attempt, count);
  }
  wire::JobStatus status() const { return answer_status({}, *state_, now_).jobs(0); }

  SendAssign assign_;
};

TEST_F(RunningTasks, are_told_with_what_their_worker_said) {
  EXPECT_EQ(status().running_size(), 1);
  EXPECT_FALSE(status().running(0).has_doing());
  say({WorkStage::check, 0, 3, 7});
  const wire::RunningTask running = status().running(0);
  EXPECT_EQ(running.task(), assign_.task.value);
  EXPECT_EQ(running.kind(), "inspect");
  EXPECT_EQ(running.doing().stage(), "check");
  EXPECT_EQ(running.doing().done(), 3U);
  EXPECT_EQ(running.doing().total(), 7U);
}

TEST_F(RunningTasks, are_not_believed_about_the_tasks_of_others) {
  const WorkerId other = new_worker();
  state_->note_work(other, assign_.task, assign_.attempt, {WorkStage::check, 0, 3, 7});
  state_->note_work(worker_, assign_.task, AttemptId{99}, {WorkStage::check, 0, 3, 7});
  state_->note_work(worker_, TaskId{99}, assign_.attempt, {WorkStage::check, 0, 3, 7});
  EXPECT_FALSE(status().running(0).has_doing());
}

TEST_F(RunningTasks, of_another_attempt_begin_anew) {
  say({WorkStage::check, 0, 6, 7});
  fail(worker_, assign_, crash());
  EXPECT_EQ(status().running_size(), 0);
  wait(60'000);
  assign_ = next(worker_);
  ASSERT_TRUE(assign_.attempt);
  EXPECT_FALSE(status().running(0).has_doing());
  say({WorkStage::check, 0, 1, 7});
  EXPECT_EQ(status().running(0).doing().done(), 1U);
}

TEST_F(RunningTasks, change_no_row) {
  say({WorkStage::check, 0, 3, 7});
  EXPECT_TRUE(state_->take_changes().empty());
}

TEST_F(RunningTasks, that_mesh_count_with_their_share_of_the_expected_elements) {
  ASSERT_TRUE(finish(worker_, assign_));
  run_until_meshes();
  assign_ = held_;
  EXPECT_EQ(status().elements_under_way(), 0);
  say({WorkStage::validate, 0, 1, 1});
  const double work = told_size(task(assign_.task))->elements;
  EXPECT_NEAR(status().elements_under_way(), work, 1e-9 * work);
  EXPECT_NEAR(status().running(0).share(), 1, 1e-12);
  ASSERT_TRUE(finish(worker_, assign_));
  EXPECT_EQ(status().elements_under_way(), 0);
}

TEST_F(RunningTasks, are_told_since_when_they_run) {
  now_.wall_ms += 2500;
  EXPECT_EQ(status().running(0).ShortDebugString(),
            R"(task: 1 kind: "inspect" attempt: 1 seconds: 2.5)");
}

TEST_F(RunningTasks, are_what_their_worker_is_told_to_do) {
  say({WorkStage::check, 1, 3, 7});
  ASSERT_EQ(state_->workers_at_work().size(), 1U);
  wire::WorkerLine line;
  add_doing(*state_, state_->workers_at_work()[0], line);
  EXPECT_EQ(line.ShortDebugString(), R"(doing { stage: "check" pass: 1 done: 3 total: 7 })");
  wire::TaskLine task_line;
  add_doing(*state_, task(assign_.task), task_line);
  EXPECT_EQ(task_line.doing().ShortDebugString(), line.doing().ShortDebugString());
  ASSERT_TRUE(finish(worker_, assign_));
  wire::WorkerLine idle;
  add_doing(*state_, state_->workers_at_work()[0], idle);
  EXPECT_FALSE(idle.has_doing());
}

TEST(ManyRunningTasks, are_told_as_far_as_people_read_them) {
  const Moment now{5000, 5000};
  JobState state(
      {}, {}, [](const ArtifactRef&) { return true; }, now);
  std::vector<TaskRow> rows(30);
  std::vector<const TaskRow*> tasks;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    rows[i].id = TaskId{i + 1};
    rows[i].attempt = AttemptId{100 - i};
    rows[i].state = TaskState::leased;
    tasks.push_back(&rows[i]);
  }
  wire::JobStatus status;
  add_running_tasks(state, tasks, now, status);
  ASSERT_EQ(status.running_size(), 20);
  EXPECT_EQ(status.running(0).attempt(), 71U) << "the first attempts first";
  EXPECT_EQ(status.running(19).attempt(), 90U);
}

}  // namespace
}  // namespace tetfarm
