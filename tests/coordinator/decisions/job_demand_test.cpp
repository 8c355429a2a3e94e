// What waits for workers, as a pool of workers is told of it.
#include "tasks/failure_cause.h"
#include "tests/coordinator/decisions/job_state_fixture.h"

namespace tetfarm {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::Pair;

constexpr std::uint64_t gib = std::uint64_t{1} << 30U;

class Demand : public JobStateTest {};

TEST_F(Demand, is_the_ready_task_until_a_worker_has_it) {
  EXPECT_THAT(state_->demand(), IsEmpty());
  submit();
  EXPECT_THAT(state_->demand(), ElementsAre(Pair(0, 1)));
  worker_ = new_worker();
  EXPECT_TRUE(next(worker_).attempt);
  EXPECT_THAT(state_->demand(), IsEmpty());
}

TEST_F(Demand, a_cut_that_is_being_made_will_bring_one_task_more_than_its_worker_can_take) {
  submit();
  worker_ = new_worker();
  finish(worker_, next(worker_));
  const SendAssign cut = next(worker_);
  ASSERT_EQ(task(cut.task).kind, TaskKind::decompose);
  std::uint64_t tasks = 0;
  for (const auto& [bytes, count] : state_->demand()) tasks += count;
  EXPECT_EQ(tasks, 1U);
}

class LoopDemand : public Demand {
 protected:
  /// A loop: its first task runs a solver.
  SubmitAnswer submit_loop() {
    Submission submission{"loop", "wing", "toml", {}};
    SolveGiven first;
    first.job = {job_file_.hash, job_file_.size};
    first.mesh = {surface_.hash, surface_.size};
    submission.loop = first;
    return state_->submit(submission, now_);
  }
};

TEST_F(LoopDemand, a_solver_waits_for_a_worker_that_runs_some) {
  const JobId loop = submit_loop().job;
  commit();
  EXPECT_THAT(state_->demand(), IsEmpty());
  EXPECT_THAT(state_->demand(true), ElementsAre(Pair(0, 1)));
  worker_ = new_worker();
  EXPECT_FALSE(next(worker_).attempt) << "it was started without --solvers";
  const TaskRow& first = state_->durable().tasks.begin()->second;
  ASSERT_EQ(first.job, loop);
  EXPECT_THAT(state_->outlook(first.id, now_).reasons,
              ElementsAre("1 of 1 workers: started without --solvers"));
  const WorkerId other = add_worker({.host = "other", .runs_solvers = true});
  EXPECT_EQ(next(other).task, first.id);
  EXPECT_THAT(state_->demand(true), IsEmpty());
}

TEST_F(LoopDemand, a_solver_that_crashed_waits_for_no_host_that_runs_none) {
  submit_loop();
  commit();
  worker_ = add_worker({.host = "here", .runs_solvers = true});
  add_worker({.host = "elsewhere"});
  TaskFailure crash;
  crash.cause = FailureCause::error;
  const SendAssign first = next(worker_);
  fail(worker_, first, crash);
  wait(rules_.lease_ms - 1);
  EXPECT_EQ(next(worker_).task, first.task);
}

TEST_F(Demand, names_the_memory_that_a_starved_task_wants_though_no_worker_has_it) {
  submit();
  worker_ =
      add_worker({.memory_bytes = 2 * gib, .shares_memory = false, .pool_memory_bytes = 16 * gib});
  TaskFailure starved;
  starved.cause = FailureCause::out_of_memory;
  starved.peak_rss_bytes = 2 * gib;
  const SendAssign first = next(worker_);
  fail(worker_, first, starved);
  EXPECT_EQ(job().phase, JobPhase::running) << "its pool can bring a larger worker";
  EXPECT_THAT(state_->demand(), ElementsAre(Pair(4 * gib, 1)));
  wait(rules_.lease_ms - 1);
  EXPECT_FALSE(next(worker_).attempt);
  const WorkerId large = add_worker({.memory_bytes = 4 * gib, .shares_memory = false});
  EXPECT_EQ(next(large).task, first.task);
}

TEST_F(Demand, what_the_largest_worker_of_a_pool_could_not_hold_goes_into_quarantine) {
  submit();
  worker_ =
      add_worker({.memory_bytes = 16 * gib, .shares_memory = false, .pool_memory_bytes = 16 * gib});
  TaskFailure starved;
  starved.cause = FailureCause::out_of_memory;
  fail(worker_, next(worker_), starved);
  EXPECT_EQ(job().phase, JobPhase::failed);
}

TEST_F(Demand, a_worker_is_known_by_the_tag_of_its_pool) {
  worker_ = add_worker({.tag = "farm/12_3"});
  ASSERT_EQ(state_->workers_at_work().size(), 1U);
  EXPECT_EQ(state_->workers_at_work().front().tag, "farm/12_3");
}

}  // namespace
}  // namespace tetfarm
