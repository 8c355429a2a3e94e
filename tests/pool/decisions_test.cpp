// What a pool decides, one look at the farm after the other.
#include "pool/decisions.h"

#include <gmock/gmock.h>

#include <random>

namespace tetfarm {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

constexpr std::uint64_t gib = std::uint64_t{1} << 30U;

PoolRules rules_of(std::size_t min, std::size_t max) {
  PoolRules rules;
  rules.name = "farm";
  rules.min = min;
  rules.max = max;
  rules.least_bytes = 4 * gib;
  rules.most_bytes = 16 * gib;
  return rules;
}

/// A batch system that starts what it is told to, and a coordinator that knows the workers.
class Pool : public testing::Test {
 protected:
  void start(const PoolRules& rules) {
    rules_ = rules;
    decisions_.emplace(rules);
  }
  PoolActions look() { return decisions_->decide({jobs_, farm_}, now_ms_); }
  /// Looks, and lets the batch system do what was decided.
  PoolActions step() {
    PoolActions actions = look();
    for (const WorkerOrder& order : actions.submit) accept(order);
    for (const std::string& id : actions.cancel) remove(id);
    return actions;
  }
  void accept(const WorkerOrder& order) {
    std::vector<std::string> ids;
    for (std::size_t i = 0; i < order.count; ++i) {
      ids.push_back(std::to_string(++last_));
      jobs_.push_back({ids.back(), PoolJobState::pending, order.bytes});
    }
    decisions_->submitted(order, ids, now_ms_);
  }
  void remove(const std::string& id) {
    std::erase_if(jobs_, [&](const PoolJob& job) { return job.id == id; });
    std::erase_if(farm_.workers, [&](const PoolWorker& w) { return w.tag == "farm/" + id; });
  }
  /// Every waiting job gets its machine, and its worker is with the coordinator.
  void run_all(bool busy) {
    for (PoolJob& job : jobs_) {
      if (job.state != PoolJobState::pending) continue;
      job.state = PoolJobState::running;
      farm_.workers.push_back(
          {std::stoull(job.id), "farm/" + job.id, busy, false, task_bytes(job.bytes)});
    }
  }
  void all_are(bool busy) {
    for (PoolWorker& worker : farm_.workers) worker.is_busy = busy;
  }
  std::size_t ordered(const PoolActions& actions) {
    std::size_t count = 0;
    for (const WorkerOrder& order : actions.submit) count += order.count;
    return count;
  }

  PoolRules rules_;
  std::optional<PoolDecisions> decisions_;
  std::vector<PoolJob> jobs_;
  CoordinatorView farm_;
  std::int64_t now_ms_ = 1'000'000;
  int last_ = 0;
};

TEST_F(Pool, submits_a_worker_for_each_task_that_has_none_and_no_more) {
  start(rules_of(0, 10));
  farm_.demand = {{gib, 3}};
  EXPECT_THAT(step().submit, ElementsAre(WorkerOrder{3, 4 * gib}));
  EXPECT_THAT(step().submit, IsEmpty()) << "they are on their way";
  farm_.demand = {{gib, 4}};
  EXPECT_EQ(ordered(step()), 1U);
}

TEST_F(Pool, never_has_more_jobs_than_the_maximum_whatever_their_state) {
  start(rules_of(0, 4));
  farm_.demand = {{0, 100}};
  EXPECT_EQ(ordered(step()), 4U);
  run_all(true);
  EXPECT_EQ(ordered(step()), 0U);
  jobs_[0].state = PoolJobState::ending;
  EXPECT_EQ(ordered(step()), 0U) << "an ending job still counts";
  remove("1");
  EXPECT_EQ(ordered(step()), 1U);
}

TEST_F(Pool, counts_what_it_submitted_until_it_is_listed) {
  start(rules_of(0, 4));
  farm_.demand = {{0, 100}};
  step();
  jobs_.clear();
  EXPECT_EQ(ordered(look()), 0U) << "the listing lags behind";
  now_ms_ += rules_.listing_ms + 1;
  EXPECT_EQ(ordered(look()), 0U) << "they vanished without a worker: a trouble";
  now_ms_ += rules_.first_backoff_ms + 1;
  EXPECT_EQ(ordered(look()), 4U);
}

TEST_F(Pool, a_restarted_pool_goes_on_with_the_jobs_that_are_listed) {
  start(rules_of(0, 5));
  farm_.demand = {{0, 100}};
  step();
  run_all(true);
  start(rules_);
  EXPECT_EQ(ordered(look()), 0U);
}

TEST_F(Pool, an_idle_worker_is_drained_after_a_while_and_cancelled_only_when_it_stays) {
  start(rules_of(0, 5));
  farm_.demand = {{0, 2}};
  step();
  run_all(true);
  farm_.demand = {};
  EXPECT_THAT(look().drain, IsEmpty());
  all_are(false);
  EXPECT_THAT(look().drain, IsEmpty()) << "it has only just become idle";
  now_ms_ += rules_.idle_ms;
  const PoolActions actions = look();
  EXPECT_THAT(actions.drain, ElementsAre(1, 2));
  EXPECT_THAT(actions.cancel, IsEmpty());
  now_ms_ += rules_.leave_ms;
  EXPECT_THAT(look().cancel, IsEmpty());
  now_ms_ += 1;
  EXPECT_THAT(look().cancel, ElementsAre("1", "2"));
}

TEST_F(Pool, a_worker_that_had_work_in_between_is_not_idle_since_before) {
  start(rules_of(0, 5));
  farm_.demand = {{0, 1}};
  step();
  run_all(false);
  farm_.demand = {};
  look();
  now_ms_ += rules_.idle_ms - 1;
  all_are(true);
  look();
  all_are(false);
  now_ms_ += 1;
  EXPECT_THAT(look().drain, IsEmpty());
}

TEST_F(Pool, keeps_the_minimum_without_work) {
  start(rules_of(2, 5));
  EXPECT_EQ(ordered(step()), 2U);
  run_all(false);
  farm_.demand = {{0, 5}};
  EXPECT_EQ(ordered(step()), 3U);
  run_all(false);
  farm_.demand = {};
  look();
  now_ms_ += rules_.idle_ms;
  EXPECT_THAT(look().drain, SizeIs(3));
}

TEST_F(Pool, a_waiting_job_that_nobody_wants_is_taken_back_in_one_batch) {
  start(rules_of(0, 5));
  farm_.demand = {{0, 5}};
  step();
  farm_.demand = {{0, 1}};
  EXPECT_THAT(look().cancel, IsEmpty());
  now_ms_ += rules_.unwanted_ms;
  EXPECT_THAT(look().cancel, SizeIs(4));
  EXPECT_THAT(look().cancel, IsEmpty()) << "asked for once";
}

TEST_F(Pool, a_waiting_job_that_was_wanted_in_between_is_not_unwanted_since_before) {
  start(rules_of(0, 5));
  farm_.demand = {{0, 1}};
  step();
  farm_.demand = {};
  look();
  now_ms_ += rules_.unwanted_ms - 1;
  farm_.demand = {{0, 1}};
  look();
  farm_.demand = {};
  EXPECT_THAT(look().cancel, IsEmpty());
  now_ms_ += rules_.unwanted_ms - 1;
  EXPECT_THAT(look().cancel, IsEmpty());
  now_ms_ += 1;
  EXPECT_THAT(look().cancel, SizeIs(1));
}

TEST_F(Pool, no_job_is_larger_than_the_largest_though_sizes_double) {
  PoolRules rules = rules_of(0, 5);
  rules.most_bytes = 12 * gib;
  start(rules);
  farm_.demand = {{100 * gib, 1}};
  EXPECT_THAT(step().submit, ElementsAre(WorkerOrder{1, 12 * gib}));
}

TEST_F(Pool, the_pause_does_not_grow_beyond_its_longest) {
  start(rules_of(0, 5));
  farm_.demand = {{0, 5}};
  for (int i = 0; i < 20; ++i) decisions_->submission_failed({5, 4 * gib}, now_ms_);
  now_ms_ += rules_.longest_backoff_ms - 1;
  EXPECT_THAT(look().submit, IsEmpty());
  now_ms_ += 1;
  EXPECT_EQ(ordered(look()), 5U);
}

TEST_F(Pool, tasks_get_jobs_of_the_size_that_they_want) {
  start(rules_of(0, 10));
  farm_.demand = {{gib, 2}, {5 * gib, 1}, {100 * gib, 1}};
  EXPECT_THAT(step().submit, ElementsAre(WorkerOrder{2, 4 * gib}, WorkerOrder{1, 8 * gib},
                                         WorkerOrder{1, 16 * gib}));
  run_all(false);
  EXPECT_THAT(step().submit, IsEmpty()) << "each has its worker now";
  farm_.demand = {{5 * gib, 3}};
  EXPECT_THAT(step().submit, ElementsAre(WorkerOrder{1, 8 * gib})) << "two of them hold 5 GiB";
}

TEST_F(Pool, somebody_elses_idle_worker_is_used_but_never_let_go) {
  start(rules_of(0, 5));
  farm_.workers.push_back({99, "", false, false, 8 * gib});
  farm_.demand = {{gib, 1}};
  EXPECT_EQ(ordered(look()), 0U);
  farm_.demand = {};
  look();
  now_ms_ += rules_.idle_ms;
  EXPECT_THAT(look().drain, IsEmpty());
}

TEST_F(Pool, while_the_batch_system_does_not_answer_nothing_is_done_and_the_pause_grows) {
  start(rules_of(0, 5));
  farm_.demand = {{0, 5}};
  EXPECT_THAT(decisions_->decide({std::nullopt, farm_}, now_ms_).submit, IsEmpty());
  EXPECT_THAT(look().submit, IsEmpty()) << "it has only just answered again";
  now_ms_ += rules_.first_backoff_ms;
  EXPECT_EQ(ordered(look()), 5U);
  decisions_->submission_failed({5, 4 * gib}, now_ms_);
  now_ms_ += rules_.first_backoff_ms;
  EXPECT_THAT(look().submit, IsEmpty()) << "twice as long";
  now_ms_ += rules_.first_backoff_ms;
  EXPECT_EQ(ordered(look()), 5U);
}

TEST_F(Pool, while_the_coordinator_does_not_answer_all_stays_as_it_is) {
  start(rules_of(0, 5));
  farm_.demand = {{0, 3}};
  step();
  run_all(false);
  look();
  now_ms_ += 10 * rules_.idle_ms;
  const PoolActions actions = decisions_->decide({jobs_, std::nullopt}, now_ms_);
  EXPECT_THAT(actions.submit, IsEmpty());
  EXPECT_THAT(actions.drain, IsEmpty());
  EXPECT_THAT(actions.cancel, IsEmpty());
}

TEST_F(Pool, submits_only_so_many_jobs_a_minute_and_so_many_at_once) {
  PoolRules rules = rules_of(0, 1000);
  rules.jobs_a_minute = 30;
  rules.most_at_once = 20;
  start(rules);
  farm_.demand = {{0, 500}};
  EXPECT_THAT(step().submit, ElementsAre(WorkerOrder{20, 4 * gib}, WorkerOrder{10, 4 * gib}));
  now_ms_ += 59'000;
  EXPECT_EQ(ordered(step()), 0U);
  now_ms_ += 1'000;
  EXPECT_EQ(ordered(step()), 30U);
}

TEST_F(Pool, jobs_that_die_before_their_worker_comes_are_not_replaced_ever_faster) {
  start(rules_of(0, 2));
  farm_.demand = {{0, 2}};
  std::size_t submitted = 0;
  for (int second = 0; second < 600; ++second) {
    submitted += ordered(step());
    look();
    jobs_.clear();  // the program is not where the script says
    now_ms_ += 1'000;
  }
  EXPECT_LE(submitted, 16U);
  EXPECT_GE(submitted, 4U);
}

TEST_F(Pool, a_held_job_is_cancelled_and_one_that_never_brings_its_worker_too) {
  start(rules_of(0, 2));
  farm_.demand = {{0, 2}};
  step();
  jobs_[0].state = PoolJobState::broken;
  jobs_[1].state = PoolJobState::running;
  EXPECT_THAT(step().cancel, ElementsAre("1"));
  now_ms_ += rules_.start_ms + 1;
  EXPECT_THAT(look().cancel, ElementsAre("2"));
}

TEST_F(Pool, a_worker_on_a_host_in_quarantine_is_replaced) {
  start(rules_of(0, 3));
  farm_.demand = {{0, 1}};
  step();
  run_all(false);
  farm_.workers[0].is_shunned = true;
  const PoolActions actions = look();
  EXPECT_THAT(actions.drain, ElementsAre(1));
  EXPECT_EQ(ordered(actions), 1U);
}

TEST_F(Pool, that_stops_drains_workers_cancels_the_rest_and_submits_nothing) {
  start(rules_of(0, 5));
  farm_.demand = {{0, 2}};
  step();
  run_all(true);
  accept({1, 4 * gib});
  PoolRules rules = rules_;
  rules.stops = true;
  start(rules);
  const PoolActions actions = look();
  EXPECT_THAT(actions.drain, ElementsAre(1, 2));
  EXPECT_THAT(actions.cancel, ElementsAre("3"));
  EXPECT_THAT(actions.submit, IsEmpty());
  start(rules);
  EXPECT_THAT(decisions_->decide({jobs_, std::nullopt}, now_ms_).cancel, SizeIs(3))
      << "nobody is there to drain them";
}

TEST_F(Pool, of_jobs_above_a_lowered_maximum_the_waiting_ones_go_first) {
  start(rules_of(0, 4));
  farm_.demand = {{0, 2}};
  step();
  run_all(false);
  accept({2, 4 * gib});
  start(rules_of(0, 2));
  farm_.demand = {};
  const PoolActions actions = look();
  EXPECT_THAT(actions.cancel, ElementsAre("3", "4"));
  EXPECT_THAT(actions.drain, IsEmpty());
}

TEST_F(Pool, of_idle_workers_above_a_lowered_maximum_no_more_leave_at_once_than_are_too_many) {
  start(rules_of(0, 4));
  farm_.demand = {{0, 4}};
  step();
  run_all(false);
  start(rules_of(0, 3));
  farm_.demand = {};
  EXPECT_THAT(look().drain, SizeIs(1));
}

/// Whatever jobs, workers and the batch system do, and however often the pool is started anew.
TEST_F(Pool, stays_below_its_maximum_in_any_course_of_events) {
  for (std::uint32_t seed = 1; seed <= 50; ++seed) {
    std::mt19937 random(seed);
    const auto chance = [&](unsigned percent) { return random() % 100 < percent; };
    jobs_.clear();
    farm_ = {};
    start(rules_of(random() % 3, 3 + random() % 8));
    for (int round = 0; round < 300; ++round) {
      now_ms_ += static_cast<std::int64_t>(random() % 20'000);
      farm_.demand = {{random() % 2 * 6 * gib, random() % 12}};
      if (chance(5)) start(rules_);
      const PoolActions actions =
          decisions_->decide({chance(10) ? std::nullopt : std::optional(jobs_),
                              chance(10) ? std::nullopt : std::optional(farm_)},
                             now_ms_);
      for (const WorkerOrder& order : actions.submit) {
        if (chance(80)) {
          accept(order);
        } else {
          decisions_->submission_failed(order, now_ms_);
        }
      }
      ASSERT_LE(jobs_.size(), rules_.max) << "seed " << seed << ", round " << round;
      for (const std::string& id : actions.cancel) remove(id);
      for (const std::uint64_t worker : actions.drain) remove(std::to_string(worker));
      if (chance(50)) run_all(chance(50));
      if (chance(30)) all_are(chance(50));
      if (!jobs_.empty() && chance(20)) remove(jobs_[random() % jobs_.size()].id);
    }
  }
}

TEST(TaskBytes, leave_an_eighth_of_a_job_or_128_MiB_for_all_else) {
  constexpr std::uint64_t mib = std::uint64_t{1} << 20U;
  EXPECT_EQ(task_bytes(8 * gib), 7 * gib);
  EXPECT_EQ(task_bytes(gib), gib - 128 * mib);
  EXPECT_EQ(task_bytes(512 * mib), 384 * mib);
  EXPECT_EQ(task_bytes(128 * mib), 0U);
  EXPECT_EQ(task_bytes(5), 0U);
}

TEST_F(Pool, a_task_gets_the_smallest_worker_that_holds_it_and_idle_ones_first) {
  start(rules_of(0, 10));
  farm_.demand = {{gib, 1}, {10 * gib, 1}};
  step();
  run_all(false);
  ASSERT_THAT(jobs_, SizeIs(2)) << "of 4 GiB and of 16";
  farm_.demand = {{gib, 1}};
  look();
  now_ms_ += rules_.idle_ms;
  EXPECT_THAT(look().drain, ElementsAre(2)) << "the large one has no work";
}

TEST_F(Pool, a_task_that_just_fits_needs_no_larger_job) {
  start(rules_of(0, 10));
  farm_.demand = {{task_bytes(4 * gib), 1}};
  EXPECT_THAT(look().submit, ElementsAre(WorkerOrder{1, 4 * gib}));
  start(rules_of(0, 10));
  farm_.demand = {{task_bytes(4 * gib) + 1, 1}};
  EXPECT_THAT(look().submit, ElementsAre(WorkerOrder{1, 8 * gib}));
}

TEST_F(Pool, pauses_double_with_each_trouble_and_a_worker_that_comes_ends_them) {
  start(rules_of(0, 5));
  EXPECT_EQ(decisions_->quiet_until_ms(), 0);
  for (const std::int64_t factor : {1, 2, 4, 8}) {
    decisions_->submission_failed({1, 4 * gib}, now_ms_);
    EXPECT_EQ(decisions_->quiet_until_ms(), now_ms_ + factor * rules_.first_backoff_ms);
  }
  accept({1, 4 * gib});
  run_all(true);
  look();
  decisions_->submission_failed({1, 4 * gib}, now_ms_);
  EXPECT_EQ(decisions_->quiet_until_ms(), now_ms_ + rules_.first_backoff_ms);
}

TEST_F(Pool, failed_submissions_count_for_the_jobs_of_a_minute) {
  PoolRules rules = rules_of(0, 100);
  rules.jobs_a_minute = 30;
  rules.first_backoff_ms = 1'000;
  start(rules);
  farm_.demand = {{0, 100}};
  decisions_->submission_failed({25, 4 * gib}, now_ms_);
  now_ms_ += rules.first_backoff_ms;
  EXPECT_EQ(ordered(look()), 5U);
}

TEST_F(Pool, a_worker_that_was_told_to_leave_by_somebody_else_serves_no_more) {
  start(rules_of(0, 5));
  farm_.demand = {{0, 1}};
  step();
  run_all(false);
  farm_.workers[0].drains = true;
  EXPECT_EQ(ordered(look()), 1U) << "another takes its task";
  now_ms_ += rules_.leave_ms + 1;
  EXPECT_THAT(look().cancel, ElementsAre("1"));
}

TEST_F(Pool, somebody_elses_worker_that_is_busy_leaves_or_is_shunned_takes_no_task) {
  for (const auto& [busy, drains, shunned] :
       {std::tuple{true, false, false}, {false, true, false}, {false, false, true}}) {
    start(rules_of(0, 5));
    farm_.workers = {{99, "others/1", busy, drains, 8 * gib, shunned}};
    farm_.demand = {{gib, 1}};
    EXPECT_EQ(ordered(look()), 1U);
  }
}

TEST_F(Pool, a_job_that_ends_serves_nobody) {
  start(rules_of(0, 5));
  farm_.demand = {{0, 1}};
  step();
  jobs_[0].state = PoolJobState::ending;
  EXPECT_EQ(ordered(look()), 1U);
}

TEST_F(Pool, asks_again_for_what_was_not_cancelled_within_a_minute) {
  start(rules_of(0, 5));
  accept({1, 4 * gib});
  jobs_[0].state = PoolJobState::broken;
  EXPECT_THAT(look().cancel, ElementsAre("1"));
  now_ms_ += 59'999;
  EXPECT_THAT(look().cancel, IsEmpty());
  now_ms_ += 1;
  EXPECT_THAT(look().cancel, ElementsAre("1"));
}

TEST_F(Pool, cancels_no_more_at_once_than_a_batch_system_takes) {
  PoolRules rules = rules_of(0, 10);
  rules.most_at_once = 2;
  start(rules);
  accept({5, 4 * gib});
  for (PoolJob& job : jobs_) job.state = PoolJobState::broken;
  EXPECT_THAT(look().cancel, ElementsAre("1", "2"));
  EXPECT_THAT(look().cancel, ElementsAre("3", "4"));
}

TEST_F(Pool, a_job_that_runs_has_its_whole_time_to_bring_a_worker) {
  start(rules_of(0, 5));
  farm_.demand = {{0, 1}};
  step();
  jobs_[0].state = PoolJobState::running;
  look();
  now_ms_ += rules_.start_ms;
  EXPECT_THAT(look().cancel, IsEmpty());
  jobs_[0].state = PoolJobState::pending;
  look();
  jobs_[0].state = PoolJobState::running;
  now_ms_ += rules_.start_ms;
  look();
  now_ms_ += rules_.start_ms;
  EXPECT_THAT(look().cancel, IsEmpty()) << "it waited again in between";
  now_ms_ += 1;
  EXPECT_THAT(look().cancel, ElementsAre("1"));
}

TEST_F(Pool, that_stops_cancels_a_worker_that_does_not_leave) {
  PoolRules rules = rules_of(0, 5);
  start(rules);
  accept({1, 4 * gib});
  run_all(true);
  rules.stops = true;
  start(rules);
  EXPECT_THAT(look().drain, ElementsAre(1));
  now_ms_ += rules.leave_ms;
  EXPECT_THAT(look().cancel, IsEmpty());
  EXPECT_THAT(look().drain, IsEmpty()) << "it was told once";
  now_ms_ += 1;
  EXPECT_THAT(look().cancel, ElementsAre("1"));
}

TEST_F(Pool, jobs_whose_workers_were_there_may_vanish_without_trouble) {
  start(rules_of(0, 5));
  accept({1, 4 * gib});
  run_all(true);
  look();
  jobs_.clear();
  farm_.workers.clear();
  look();
  EXPECT_EQ(decisions_->quiet_until_ms(), 0);
  accept({1, 4 * gib});
  look();
  jobs_.clear();
  look();
  EXPECT_EQ(decisions_->quiet_until_ms(), now_ms_ + rules_.first_backoff_ms)
      << "this one never brought a worker";
}

TEST_F(Pool, a_job_that_is_not_listed_yet_is_not_taken_back) {
  start(rules_of(0, 5));
  farm_.demand = {{0, 1}};
  step();
  jobs_.clear();
  farm_.demand = {};
  look();
  now_ms_ += rules_.unwanted_ms;
  EXPECT_THAT(look().cancel, IsEmpty()) << "the batch system does not know it";
}

}  // namespace
}  // namespace tetfarm
