// Jobs that wait for other jobs: when they begin, and what becomes of them when those do not end
// well.
#include "tests/coordinator/decisions/job_state_fixture.h"

namespace tetfarm {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class JobDependencies : public JobStateTest {
 protected:
  SubmitAnswer submit_after(const std::vector<JobId>& after, const std::string& key = "") {
    Submission submission{key, "box", "toml", to_inspect(job_file_, surface_)};
    submission.after = after;
    const SubmitAnswer answer = state_->submit(submission, now_);
    commit();
    return answer;
  }
  const JobRow& row(JobId job) const { return state_->durable().jobs.at(job); }
  JobSummary summary_of_job(JobId job) const {
    return summary_of(state_->durable(), row(job), "", now_.wall_ms);
  }
  TaskId first_task_of(JobId job) const {
    for (const auto& [id, task] : state_->durable().tasks) {
      if (task.job == job) return id;
    }
    return {};
  }
  void fail_first_task() {
    if (!worker_) worker_ = new_worker();
    TaskFailure failure;
    failure.message = "open edge";
    failure.exit_code = 3;
    ASSERT_TRUE(fail(worker_, next(worker_), failure));
  }
};

TEST_F(JobDependencies, keep_a_job_from_beginning_until_the_others_are_done) {
  const JobId first = submit("first").job;
  const JobId second = submit_after({first}).job;
  EXPECT_EQ(row(second).phase, JobPhase::waiting);
  EXPECT_EQ(row(second).finished_ms, 0);
  worker_ = new_worker();
  for (SendAssign assign = next(worker_); row(first).phase == JobPhase::running;
       assign = next(worker_)) {
    ASSERT_EQ(task(assign.task).job, first);
    ASSERT_TRUE(finish(worker_, assign));
  }
  EXPECT_EQ(row(second).phase, JobPhase::done)
      << "the same surface: all of it has been done by the first, but not before that was done";
  EXPECT_EQ(record_.events().back().what, "job done");
}

TEST_F(JobDependencies, are_told_of_a_waiting_job_and_of_its_task) {
  const JobId first = submit("first").job;
  const JobId other = submit("other").job;
  const JobId last = submit_after({other, first, other}).job;
  EXPECT_THAT(row(last).after, ElementsAre(first, other)) << "each once, by rising number";
  const JobSummary told = summary_of_job(last);
  EXPECT_EQ(told.state, "waiting");
  EXPECT_EQ(told.message,
            "waits for job-1 (wing), which is running; job-2 (wing), which is running");
  EXPECT_THAT(told.after, ElementsAre(first, other));
  EXPECT_THAT(told.waits_for, ElementsAre(first, other));
  EXPECT_THAT(state_->outlook(first_task_of(last), now_).reasons,
              ElementsAre(HasSubstr("its job waits for job-1 (wing)")));
  EXPECT_EQ(state_->demand().at(0), 2U) << "no workers are asked for what waits";
  state_->cancel(last, now_);
  EXPECT_THAT(summary_of_job(last).waits_for, IsEmpty());
  EXPECT_THAT(summary_of_job(last).after, ElementsAre(first, other));
}

TEST_F(JobDependencies, on_jobs_that_are_done_are_met_at_once) {
  worker_ = new_worker();
  const JobId first = submit("first").job;
  run_all();
  ASSERT_EQ(row(first).phase, JobPhase::done);
  EXPECT_NE(row(submit_after({first}).job).phase, JobPhase::waiting);
}

TEST_F(JobDependencies, on_jobs_that_are_unknown_or_did_not_end_well_are_refused) {
  const JobId first = submit("first").job;
  state_->cancel(first, now_);
  commit();
  EXPECT_EQ(submit_after({first}).unmet, first);
  EXPECT_EQ(submit_after({JobId{99}}).unmet, JobId{99});
  EXPECT_EQ(submit_after({JobId{2}}).unmet, JobId{2}) << "none can wait for itself";
  EXPECT_EQ(state_->durable().jobs.size(), 1U);
}

TEST_F(JobDependencies, that_fail_end_a_whole_chain_with_the_same_exit_code) {
  const JobId first = submit("first").job;
  const JobId second = submit_after({first}).job;
  const JobId third = submit_after({second}).job;
  fail_first_task();
  ASSERT_EQ(row(first).phase, JobPhase::failed);
  EXPECT_EQ(row(second).phase, JobPhase::failed);
  EXPECT_EQ(row(second).exit_code, 3);
  EXPECT_EQ(row(second).message,
            "it waited for job-1 (wing), which failed; when that goes on, retry this one");
  EXPECT_EQ(row(third).phase, JobPhase::failed);
  EXPECT_THAT(row(third).message, HasSubstr("it waited for job-2 (box), which failed"));
}

TEST_F(JobDependencies, that_are_cancelled_cancel_what_waits) {
  const JobId first = submit("first").job;
  const JobId second = submit_after({first}).job;
  state_->cancel(first, now_);
  commit();
  EXPECT_EQ(row(second).phase, JobPhase::cancelled);
  EXPECT_THAT(row(second).message, HasSubstr("job-1 (wing), which was cancelled"));
  EXPECT_EQ(record_.events().back().what, "cancelled");
}

TEST_F(JobDependencies, that_go_on_let_the_others_be_retried) {
  const JobId first = submit("first").job;
  const JobId second = submit_after({first}).job;
  fail_first_task();
  ASSERT_EQ(row(second).phase, JobPhase::failed);
  EXPECT_EQ(state_->unmet_by(second), first);
  EXPECT_EQ(state_->retry(first, {}, now_), 1U);
  EXPECT_FALSE(state_->unmet_by(second));
  EXPECT_EQ(state_->retry(second, {}, now_), 1U);
  commit();
  EXPECT_EQ(row(second).phase, JobPhase::waiting);
  EXPECT_EQ(row(second).message, "");
  run_all();
  EXPECT_EQ(row(first).phase, JobPhase::done);
  EXPECT_EQ(row(second).phase, JobPhase::done);
}

TEST_F(JobDependencies, are_as_before_after_a_restart) {
  const JobId first = submit("first").job;
  const JobId second = submit_after({first}).job;
  restart();
  commit();
  EXPECT_EQ(row(second).phase, JobPhase::waiting);
  worker_ = new_worker();
  while (row(first).phase == JobPhase::running) {
    const SendAssign assign = next(worker_);
    const TaskResult result = run_fake_task(task(assign.task));
    for (const ArtifactRef& file : result.outputs) files_.insert(file.hash);
    state_->done(worker_, assign.task, assign.attempt, result, now_);
    if (row(first).phase == JobPhase::running) answer();
  }
  // Killed after the first job's end was committed, and before the second began.
  record_.apply(state_->take_changes());
  restart();
  EXPECT_EQ(row(second).phase, JobPhase::waiting);
  commit();
  EXPECT_NE(row(second).phase, JobPhase::waiting);
}

TEST_F(JobDependencies, leave_a_waiting_job_to_be_cancelled_and_given_a_priority) {
  const JobId first = submit("first").job;
  const JobId second = submit_after({first}, "its key").job;
  EXPECT_TRUE(state_->set_priority(second, 9, now_));
  EXPECT_EQ(row(second).priority, 9);
  worker_ = new_worker();
  EXPECT_EQ(task(next(worker_).task).job, first) << "it waits, however urgent it is";
  EXPECT_TRUE(state_->cancel(second, now_));
  EXPECT_EQ(row(second).phase, JobPhase::cancelled);
  EXPECT_TRUE(submit_after({first}, "its key").existed);
  EXPECT_EQ(row(second).phase, JobPhase::waiting) << "submitted again, it goes on waiting";
}

}  // namespace
}  // namespace tetfarm
