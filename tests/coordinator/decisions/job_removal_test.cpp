// Jobs that ended long ago are forgotten, with the files that only they need.
#include "coordinator/decisions/finished_jobs.h"
#include "tests/coordinator/decisions/job_state_fixture.h"

namespace tetfarm {
namespace {

using testing::IsEmpty;
using testing::IsSupersetOf;

constexpr std::int64_t one_day_ms = 86'400'000;

class JobRemoval : public JobStateTest {
 protected:
  JobRemoval() { restart(); }

  void restart() {
    finished_ = FinishedJobs({[this](JobId job) { return record_.rows_of(job); },
                              [this](TaskId task) { return record_.row_of(task); }});
    DurableState rows = record_.unfinished();
    finished_.put_others_than(rows);
    state_ = std::make_unique<JobState>(
        std::move(rows), rules_,
        [this](const ArtifactRef& file) { return files_.contains(file.hash); }, now_, &finished_);
  }
  void let_go() {
    commit();
    for (const DurableState& job : state_->take_finished()) finished_.put(job);
    EXPECT_THAT(state_->validate(), IsEmpty());
  }
  JobId finish_job(const std::string& key, const std::vector<JobId>& after = {}) {
    Submission submission{key, "wing", "toml", to_inspect(job_file_, surface_)};
    submission.after = after;
    const JobId job = state_->submit(submission, now_).job;
    commit();
    if (!worker_ || !state_->knows_worker(worker_)) worker_ = new_worker();
    run_all();
    let_go();
    return job;
  }
  /// Files that nobody needs then.
  std::vector<std::string> forget(JobId job) {
    const DurableState rows = record_.rows_of(job);
    commit();
    finished_.forget(rows);
    for (const auto& [id, task] : rows.tasks) {
      for (const ArtifactRef& file : task.inputs) state_->consider_file(file.hash);
      for (const ArtifactRef& file : task.outputs) state_->consider_file(file.hash);
    }
    return state_->take_unneeded_files();
  }
  void age(std::int64_t days) { now_.wall_ms += days * one_day_ms; }

  FinishedJobs finished_;
};

TEST_F(JobRemoval, takes_a_job_when_its_days_are_over_and_not_before) {
  const JobId job = finish_job("key");
  age(6);
  EXPECT_FALSE(state_->remove_old_job(7 * one_day_ms, now_));
  age(1);
  EXPECT_EQ(state_->remove_old_job(7 * one_day_ms, now_), job);
  EXPECT_THAT(forget(job), IsSupersetOf({surface_.hash, job_file_.hash}));
  EXPECT_THAT(record_.state().jobs, IsEmpty());
  EXPECT_THAT(record_.state().tasks, IsEmpty());
  EXPECT_EQ(record_.events().back().what, "removed");
  EXPECT_FALSE(state_->remove_old_job(7 * one_day_ms, now_));
  const SubmitAnswer again = submit("key");
  EXPECT_FALSE(again.existed);
  EXPECT_GT(again.job, job) << "its number is not given out again";
}

TEST_F(JobRemoval, of_the_newest_job_leaves_its_number_taken_after_a_restart) {
  const JobId job = finish_job("key");
  age(7);
  ASSERT_EQ(state_->remove_old_job(7 * one_day_ms, now_), job);
  forget(job);
  restart();
  EXPECT_GT(submit("key").job, job);
}

TEST_F(JobRemoval, leaves_files_that_another_job_needs) {
  const JobId first = finish_job("first");
  age(7);
  const JobId second = finish_job("second");
  ASSERT_EQ(state_->remove_old_job(7 * one_day_ms, now_), first);
  EXPECT_THAT(forget(first), IsEmpty()) << "the second has the same";
  age(7);
  ASSERT_EQ(state_->remove_old_job(7 * one_day_ms, now_), second);
  EXPECT_THAT(forget(second), IsSupersetOf({surface_.hash, job_file_.hash}));
}

TEST_F(JobRemoval, leaves_what_runs_and_what_others_wait_for) {
  const JobId first = finish_job("first");
  Submission running{"running", "wing", "another", to_inspect(fake_job(4, 0), surface_)};
  files_.insert(fake_job(4, 0).hash);
  const JobId second = state_->submit(running, now_).job;
  Submission waits = running;
  waits.key = "waits";
  waits.after = {first, second};
  const JobId third = state_->submit(waits, now_).job;
  let_go();
  age(100);
  EXPECT_FALSE(state_->remove_old_job(one_day_ms, now_));
  state_->cancel(second, now_);
  let_go();
  EXPECT_FALSE(state_->remove_old_job(one_day_ms, now_)) << "the third may still be retried";
  age(1);
  EXPECT_EQ(state_->remove_old_job(one_day_ms, now_), third);
  forget(third);
  EXPECT_EQ(state_->remove_old_job(one_day_ms, now_), second);
  forget(second);
  EXPECT_EQ(state_->remove_old_job(one_day_ms, now_), first);
}

TEST_F(JobRemoval, leaves_a_job_whose_end_is_still_to_be_told) {
  rules_.tells_ends = true;
  restart();
  const JobId job = finish_job("key");
  age(10);
  EXPECT_FALSE(state_->remove_old_job(one_day_ms, now_));
  const std::int64_t finished_ms = state_->durable().jobs.at(job).finished_ms;
  state_->end_was_told(job, finished_ms, "", now_);
  EXPECT_EQ(state_->remove_old_job(one_day_ms, now_), job);
  forget(job);
  EXPECT_THAT(record_.state().jobs, IsEmpty());
}

TEST_F(JobRemoval, that_was_not_committed_did_not_happen) {
  const JobId job = finish_job("key");
  age(10);
  ASSERT_EQ(state_->remove_old_job(one_day_ms, now_), job);
  state_->take_changes();
  restart();
  EXPECT_TRUE(submit("key").existed);
}

}  // namespace
}  // namespace tetfarm
