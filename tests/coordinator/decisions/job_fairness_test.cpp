// Users take turns: whoever has the fewest tasks at work is given the next, however many jobs the
// others submitted before.
#include <map>

#include "tests/coordinator/decisions/job_state_fixture.h"
#include "tests/coordinator/simulation_random.h"

namespace tetfarm {
namespace {

using testing::HasSubstr;

class JobFairness : public JobStateTest {
 protected:
  SubmitAnswer submit_as(const std::string& owner, int priority = 0) {
    // Each is another surface, so that none is done for another.
    const ArtifactRef own = fake_file("surface", "surface " + std::to_string(++surfaces_));
    files_.insert(own.hash);
    Submission submission{"", "wing", "toml", to_inspect(job_file_, own)};
    submission.owner = owner;
    submission.priority = priority;
    const SubmitAnswer answer = state_->submit(submission, now_);
    commit();
    return answer;
  }
  const std::string& owner_of(const SendAssign& assign) const {
    return state_->durable().jobs.at(task(assign.task).job).owner;
  }
  std::map<std::string, int> ready_of_users() const {
    std::map<std::string, int> ready;
    for (const auto& [id, row] : state_->durable().tasks) {
      const JobRow& job = state_->durable().jobs.at(row.job);
      if (row.state == TaskState::ready && job.phase == JobPhase::running) ++ready[job.owner];
    }
    return ready;
  }

  int surfaces_ = 0;
};

TEST_F(JobFairness, gives_a_late_user_the_next_worker) {
  for (int i = 0; i < 5; ++i) submit_as("anna");
  submit_as("berta");
  std::map<std::string, int> given;
  for (int i = 0; i < 4; ++i) ++given[owner_of(next(new_worker()))];
  EXPECT_EQ(given["berta"], 1) << "all that she has";
  EXPECT_EQ(given["anna"], 3);
}

TEST_F(JobFairness, heeds_priorities_first) {
  submit_as("anna", 1);
  submit_as("anna", 1);
  submit_as("berta");
  EXPECT_EQ(owner_of(next(new_worker())), "anna");
  EXPECT_EQ(owner_of(next(new_worker())), "anna");
  EXPECT_EQ(owner_of(next(new_worker())), "berta");
}

TEST_F(JobFairness, is_what_explain_counts_by) {
  submit_as("anna");
  submit_as("anna");
  const JobId late = submit_as("berta").job;
  next(new_worker());
  const WorkerId leaves = new_worker();
  state_->drain(leaves);
  for (const auto& [id, row] : state_->durable().tasks) {
    if (row.job != late) continue;
    for (const std::string& reason : state_->outlook(id, now_).reasons) {
      EXPECT_THAT(reason, testing::Not(HasSubstr("before it"))) << "anna has one at work";
    }
  }
}

TEST_F(JobFairness, holds_in_a_farm_that_is_drawn_by_chance) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    record_ = {};
    restart();
    simulation::Random random(seed);
    for (int i = 0; i < 9; ++i) submit_as("user-" + std::to_string(random.pick(3)));
    std::map<WorkerId, SendAssign> at_work;
    for (int i = 0; i < 5; ++i) at_work[new_worker()] = {};
    for (int step = 0; step < 200; ++step) {
      auto some = at_work.begin();
      std::advance(some, random.pick(5));
      auto& [worker, assign] = *some;
      if (assign.attempt) {
        ASSERT_TRUE(finish(worker, assign));
      }
      assign = {};
      std::map<std::string, int> busy;
      for (const auto& [other, held] : at_work) {
        if (held.attempt) ++busy[owner_of(held)];
      }
      const std::map<std::string, int> ready = ready_of_users();
      assign = next(worker);
      if (!assign.attempt || ready.empty()) continue;
      for (const auto& [user, count] : ready) {
        EXPECT_LE(busy[owner_of(assign)], busy[user]) << user << " had fewer at work";
      }
    }
  }
}

TEST_F(JobFairness, lets_each_user_have_so_many_jobs_and_no_more) {
  rules_.jobs_per_user = 2;
  restart();
  const JobId first = submit_as("anna").job;
  EXPECT_TRUE(submit_as("anna").job);
  EXPECT_TRUE(submit_as("anna").is_one_too_many);
  EXPECT_TRUE(submit_as("berta").job) << "she has none yet";
  EXPECT_EQ(state_->durable().jobs.size(), 3U);
  state_->cancel(first, now_);
  EXPECT_TRUE(submit_as("anna").job) << "one has ended";
  EXPECT_TRUE(state_->has_all_jobs("anna")) << "so the first cannot go on for now";
  restart();
  EXPECT_TRUE(submit_as("anna").is_one_too_many) << "as before the restart";
}

}  // namespace
}  // namespace tetfarm
