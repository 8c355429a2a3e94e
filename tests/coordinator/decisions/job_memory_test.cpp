// Tasks that are out of memory, and how workers are packed.
#include "tasks/failure_cause.h"
#include "tests/coordinator/decisions/job_state_fixture.h"

namespace tetfarm {
namespace {

using testing::HasSubstr;

class Memory : public JobStateTest {
 protected:
  static constexpr std::uint64_t gib = std::uint64_t{1} << 30U;
  static TaskFailure starved(std::uint64_t peak) {
    TaskFailure failure;
    failure.message = "out of memory";
    failure.cause = FailureCause::out_of_memory;
    failure.peak_rss_bytes = peak;
    return failure;
  }
  void pass(std::int64_t ms, std::initializer_list<WorkerId> workers) {
    now_.steady_ms += ms;
    for (const WorkerId worker : workers) state_->heartbeat(worker, {}, {}, now_);
  }
};

TEST_F(Memory, a_task_out_of_memory_asks_for_twice_as_much_on_a_worker_that_has_it) {
  submit();
  const WorkerId small = add_worker({.memory_bytes = 2 * gib, .shares_memory = false});
  const WorkerId large = add_worker({.memory_bytes = 8 * gib, .shares_memory = false});
  const SendAssign first = next(small);
  fail(small, first, starved(2 * gib));
  EXPECT_EQ(task(first.task).oom_count, 1U);
  EXPECT_EQ(task(first.task).crashes + task(first.task).losses, 0U);
  EXPECT_EQ(task(first.task).memory_bytes, 4 * gib);
  pass(rules_.lease_ms - 1, {small, large});
  EXPECT_FALSE(next(small).attempt) << "it has 2 GiB";
  const SendAssign second = next(large);
  EXPECT_EQ(second.task, first.task);
  EXPECT_TRUE(finish(large, second));
  EXPECT_NE(summary().state, "stuck");
}

TEST_F(Memory, what_the_largest_worker_cannot_hold_goes_into_quarantine_with_the_reason) {
  submit();
  worker_ = add_worker({.memory_bytes = 2 * gib, .shares_memory = false});
  fail(worker_, next(worker_), starved(2 * gib));
  EXPECT_EQ(job().phase, JobPhase::failed);
  EXPECT_EQ(job().exit_code, 6);
  EXPECT_THAT(job().message, HasSubstr("out of memory"));
  EXPECT_THAT(job().message, HasSubstr("the largest worker has 2048 MiB"));
}

TEST_F(Memory, workers_that_share_a_host_are_packed_by_its_memory) {
  submit();
  const WorkerId one = add_worker({.host = "shared", .memory_bytes = 8 * gib});
  fail(one, next(one), starved(3 * gib));
  pass(rules_.elsewhere_ms + 1000, {one});
  const SendAssign hungry = next(one);
  EXPECT_EQ(record_.state().running_attempts.at(hungry.attempt).memory_bytes, 6 * gib);
  submit("other");
  const WorkerId two = add_worker({.host = "shared", .memory_bytes = 8 * gib});
  const SendAssign other = next(two);
  fail(two, other, starved(2 * gib));
  pass(1000, {two});
  state_->heartbeat(one, hungry.task, hungry.attempt, now_);
  pass(rules_.elsewhere_ms, {two});
  state_->heartbeat(one, hungry.task, hungry.attempt, now_);
  EXPECT_EQ(task(other.task).memory_bytes, 4 * gib);
  EXPECT_FALSE(next(two).attempt) << "2 of 8 GiB are left there";
  EXPECT_EQ(next(add_worker({.host = "elsewhere", .memory_bytes = 8 * gib})).task, other.task);
}

TEST_F(Memory, tasks_that_are_handed_out_at_one_moment_share_what_their_host_has) {
  submit();
  const WorkerId one = add_worker({.host = "a", .memory_bytes = 8 * gib});
  const SendAssign first = next(one);
  fail(one, first, starved(3 * gib));
  submit("other");
  const WorkerId two = add_worker({.host = "b", .memory_bytes = 8 * gib});
  const SendAssign second = next(two);
  ASSERT_NE(second.task, first.task);
  fail(two, second, starved(3 * gib));
  state_->worker_left(one, false, now_);
  state_->worker_left(two, false, now_);
  now_.steady_ms += rules_.longest_delay_ms;
  commit();
  for (int i = 0; i < 2; ++i) {
    const WorkerId worker = add_worker({.host = "shared", .memory_bytes = 8 * gib});
    state_->worker_is_ready(worker, now_);
  }
  commit();
  ASSERT_EQ(record_.state().running_attempts.size(), 1U) << "one wants 6 of 8 GiB";
  EXPECT_EQ(record_.state().running_attempts.begin()->second.memory_bytes, 6 * gib);
}

TEST_F(Memory, after_a_restart_what_absent_workers_run_is_still_in_their_hosts_memory) {
  submit();
  const WorkerId one = add_worker({.host = "shared", .memory_bytes = 8 * gib, .nonce = "one"});
  fail(one, next(one), starved(3 * gib));
  pass(rules_.elsewhere_ms + 1000, {one});
  const SendAssign hungry = next(one);
  ASSERT_EQ(record_.state().running_attempts.at(hungry.attempt).memory_bytes, 6 * gib);
  submit("other");
  const WorkerId two = add_worker({.host = "elsewhere", .memory_bytes = 8 * gib});
  fail(two, next(two), starved(2 * gib));
  pass(2000, {two});
  restart();
  WorkerId back = add_worker({.host = "shared", .memory_bytes = 8 * gib, .nonce = "two"});
  EXPECT_FALSE(next(back).attempt) << "2 of 8 GiB are left there: the first one runs still";
  now_.steady_ms += rules_.lease_ms + 1;
  commit();
  back = add_worker({.host = "shared", .memory_bytes = 8 * gib, .nonce = "two"});
  EXPECT_TRUE(next(back).attempt) << "it did not come back";
}

TEST_F(Memory, doubling_ends_at_all_that_the_host_has) {
  submit();
  worker_ = add_worker({.memory_bytes = 8 * gib});
  int tries = 0;
  while (job().phase == JobPhase::running && tries < 20) {
    pass(60000, {worker_});
    commit();
    worker_ = state_->knows_worker(worker_) ? worker_ : add_worker({.memory_bytes = 8 * gib});
    const SendAssign assign = next(worker_);
    if (!assign.attempt) continue;
    fail(worker_, assign, starved(gib));
    ++tries;
  }
  EXPECT_EQ(job().phase, JobPhase::failed);
  EXPECT_EQ(tries, 4) << "with what is there, 2, 4 and 8 GiB";
}

}  // namespace
}  // namespace tetfarm
