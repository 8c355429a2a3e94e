// Hosts on which tasks crash, beside hosts on which they do not.
#include "tests/coordinator/decisions/job_state_fixture.h"

namespace tetfarm {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class BadHost : public JobStateTest {
 protected:
  BadHost() { meet(); }

  void meet() {
    bad_ = add_worker({.host = "bad"});
    good_ = add_worker({.host = "good"});
  }
  /// A job of its own: no other has done any of its work.
  JobId submit_job(std::uint64_t parts) {
    const ArtifactRef file = fake_job(parts, 0);
    files_.insert(file.hash);
    const JobId job =
        state_->submit({file.hash, "wing", "toml", to_inspect(file, surface_)}, now_).job;
    commit();
    return job;
  }
  void pass(std::int64_t ms) {
    now_.steady_ms += ms;
    for (const WorkerId worker : {bad_, good_}) {
      if (state_->knows_worker(worker)) state_->heartbeat(worker, {}, {}, now_);
    }
  }
  /// What the bad host is given crashes; the good one then does all that it is given.
  TaskId crash_there_and_work_here() {
    const SendAssign assign = next(bad_);
    if (!assign.attempt) return {};
    fail(bad_, assign, crash());
    pass(rules_.crash_delay_ms);
    for (SendAssign done = next(good_); done.attempt; done = next(good_)) {
      EXPECT_TRUE(finish(good_, done));
      if (done.task == assign.task) break;
    }
    return assign.task;
  }
  bool is_quarantined(const std::string& host) const {
    return state_->durable().quarantined_hosts.contains(host);
  }
  std::uint32_t crashes_of_all_tasks() const {
    std::uint32_t count = 0;
    for (const auto& [id, row] : state_->durable().tasks) count += row.crashes;
    return count;
  }

  WorkerId bad_;
  WorkerId good_;
};

TEST_F(BadHost, is_quarantined_when_others_did_what_crashed_there_for_more_than_one_job) {
  submit_job(8);
  std::size_t crashed = 0;
  for (; crashed < rules_.host_tasks; ++crashed) ASSERT_TRUE(crash_there_and_work_here());
  EXPECT_FALSE(is_quarantined("bad")) << "all of one job";
  state_->cancel(JobId{1}, now_);
  submit_job(4);
  ASSERT_TRUE(crash_there_and_work_here());
  ASSERT_TRUE(is_quarantined("bad"));
  EXPECT_THAT(state_->durable().quarantined_hosts.at("bad").reason,
              AllOf(HasSubstr("4 tasks of 2 jobs failed there and were done elsewhere"),
                    HasSubstr("signal 11")));
  EXPECT_EQ(crashes_of_all_tasks(), 0U) << "they are not blamed";
  EXPECT_FALSE(next(bad_).attempt);
  EXPECT_TRUE(next(good_).attempt);
  restart();
  meet();
  EXPECT_FALSE(next(bad_).attempt) << "it stays so after a restart";
  EXPECT_FALSE(state_->release_host("good", now_));
  EXPECT_TRUE(state_->release_host("bad", now_));
  EXPECT_TRUE(next(bad_).attempt);
}

TEST_F(BadHost, is_not_proven_by_one_job_which_is_done_all_the_same) {
  const JobId job = submit_job(8);
  std::size_t crashed = 0;
  while (crash_there_and_work_here()) ++crashed;
  EXPECT_GT(crashed, 2U * rules_.host_tasks);
  EXPECT_FALSE(is_quarantined("bad"));
  EXPECT_EQ(state_->durable().jobs.at(job).phase, JobPhase::done);
}

TEST_F(BadHost, is_not_blamed_for_tasks_that_crash_elsewhere_too) {
  // Each job has one task at first, which crashes wherever it runs.
  for (std::uint64_t parts = 2; parts < 2 + 2 * rules_.host_tasks; ++parts) submit_job(parts);
  for (int round = 0; round < 40; ++round) {
    for (const WorkerId worker : {bad_, good_}) {
      const SendAssign assign = next(worker);
      if (assign.attempt) fail(worker, assign, crash());
    }
    EXPECT_TRUE(state_->durable().quarantined_hosts.empty());
    pass(rules_.lease_ms / 2);
  }
  for (const auto& [id, row] : state_->durable().jobs) EXPECT_EQ(row.phase, JobPhase::failed);
}

TEST_F(BadHost, is_forgiven_when_it_does_a_task) {
  submit_job(8);
  for (std::size_t i = 0; i < rules_.host_tasks; ++i) ASSERT_TRUE(crash_there_and_work_here());
  const SendAssign done = next(bad_);
  ASSERT_TRUE(finish(bad_, done));
  submit_job(4);
  ASSERT_TRUE(crash_there_and_work_here());
  EXPECT_FALSE(is_quarantined("bad"));
}

TEST_F(BadHost, gets_a_task_that_crashed_there_again_only_when_no_other_is_there) {
  submit_job(2);
  fail(bad_, next(bad_), crash());
  const WorkerId neighbour = add_worker({.host = "bad"});
  for (int i = 0; i < 10; ++i) {
    pass(rules_.lease_ms / 2);
    state_->heartbeat(neighbour, {}, {}, now_);
    EXPECT_FALSE(next(bad_).attempt);
    EXPECT_FALSE(next(neighbour).attempt);
  }
  state_->worker_left(good_, false, now_);
  EXPECT_TRUE(next(neighbour).attempt);
}

TEST_F(BadHost, alone_does_not_bring_a_task_into_quarantine_when_another_comes_in_time) {
  state_->worker_left(good_, false, now_);
  const JobId job = submit_job(2);
  SendAssign assign;
  for (std::uint32_t i = 0; i < rules_.max_crashes; ++i) {
    pass(rules_.lease_ms / 2);
    assign = next(bad_);
    ASSERT_TRUE(assign.attempt);
    if (i + 1 < rules_.max_crashes) fail(bad_, assign, crash());
  }
  good_ = add_worker({.host = "good"});
  fail(bad_, assign, crash());
  EXPECT_EQ(task(assign.task).state, TaskState::ready);
  pass(rules_.lease_ms / 2);
  EXPECT_EQ(next(good_).task, assign.task);
  EXPECT_EQ(state_->durable().jobs.at(job).phase, JobPhase::running);
}

TEST_F(JobStateTest, the_only_host_is_never_quarantined_but_the_task_is) {
  submit();
  worker_ = new_worker();
  for (std::uint32_t i = 0; i < rules_.max_crashes; ++i) {
    const SendAssign assign = next(worker_);
    ASSERT_TRUE(assign.attempt);
    fail(worker_, assign, crash());
    wait(rules_.lease_ms / 2);
  }
  EXPECT_TRUE(state_->durable().quarantined_hosts.empty());
  EXPECT_EQ(job().phase, JobPhase::failed);
}

}  // namespace
}  // namespace tetfarm
