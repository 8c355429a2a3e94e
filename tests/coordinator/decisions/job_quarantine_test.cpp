// Tasks that fail again and again.
#include "tests/coordinator/decisions/job_state_fixture.h"

namespace tetfarm {
namespace {

using testing::HasSubstr;

class Quarantine : public JobStateTest {
 protected:
  /// Two mesh tasks fail for good; all the others are done.
  void run_with_two_poisoned() {
    submit();
    worker_ = new_worker();
    for (TaskId* poisoned : {&first_, &second_}) {
      run_until_meshes();
      *poisoned = held_.task;
      fail(worker_, held_, {});
    }
    run_all();
  }

  TaskId first_;
  TaskId second_;
};

TEST_F(Quarantine, the_other_tasks_go_on_when_one_is_in_quarantine_and_the_job_ends_with_its_name) {
  submit();
  worker_ = new_worker();
  run_until_meshes();
  const SendAssign bad = held_;
  fail(worker_, bad, {});
  EXPECT_EQ(job().phase, JobPhase::running);
  EXPECT_EQ(task(bad.task).state, TaskState::failed);
  std::size_t meshed = 0;
  for (SendAssign assign = next(worker_); assign.attempt; assign = next(worker_)) {
    if (task(assign.task).kind == TaskKind::mesh) ++meshed;
    ASSERT_TRUE(finish(worker_, assign));
  }
  EXPECT_EQ(meshed + 1, tasks(JobId{1}, TaskKind::mesh)) << "every other leaf is meshed";
  EXPECT_EQ(job().phase, JobPhase::failed);
  EXPECT_THAT(job().message, HasSubstr(place_of(task(bad.task))));
}

TEST_F(Quarantine, a_job_names_every_task_in_quarantine) {
  run_with_two_poisoned();
  EXPECT_EQ(job().phase, JobPhase::failed);
  EXPECT_THAT(job().message, HasSubstr("2 tasks are in quarantine"));
  EXPECT_THAT(job().message, HasSubstr(place_of(task(first_))));
  EXPECT_THAT(job().message, HasSubstr(place_of(task(second_))));
}

TEST_F(Quarantine, retry_takes_one_task_out_of_quarantine_or_all_of_them) {
  run_with_two_poisoned();
  EXPECT_EQ(state_->retry(JobId{7}, {}, now_), 0U);
  EXPECT_EQ(state_->retry(JobId{1}, TaskId{1}, now_), 0U) << "it is done, not in quarantine";
  EXPECT_EQ(state_->retry(JobId{1}, first_, now_), 1U);
  run_all();
  EXPECT_EQ(task(first_).state, TaskState::done);
  EXPECT_EQ(job().phase, JobPhase::failed) << "the other is still in quarantine";
  restart();
  worker_ = new_worker();
  EXPECT_EQ(state_->retry(JobId{1}, {}, now_), 1U);
  run_all();
  EXPECT_EQ(job().phase, JobPhase::done);
  EXPECT_EQ(state_->retry(JobId{1}, {}, now_), 0U) << "a job that is done has nothing to retry";
}

}  // namespace
}  // namespace tetfarm
