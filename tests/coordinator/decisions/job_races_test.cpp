// Whose result counts, expectations of time, and second attempts.
#include "tests/coordinator/decisions/job_state_fixture.h"

namespace tetfarm {
namespace {

using testing::IsEmpty;
using testing::SizeIs;

class Fencing : public JobStateTest {};

TEST_F(Fencing, another_process_cannot_go_on_with_an_attempt) {
  submit();
  worker_ = add_worker({.nonce = "first"});
  const SendAssign assign = next(worker_);
  restart();
  const WorkerId impostor =
      state_->add_worker({.nonce = "second"}, assign.task, assign.attempt, now_);
  std::vector<Command> commands = state_->take_commands();
  EXPECT_FALSE(std::get<SendWelcome>(commands.front()).keep_running);
  EXPECT_FALSE(finish(impostor, assign)) << "the result is another's";
  const WorkerId again = state_->add_worker({.nonce = "first"}, assign.task, assign.attempt, now_);
  commands = state_->take_commands();
  EXPECT_TRUE(std::get<SendWelcome>(commands.front()).keep_running);
  EXPECT_TRUE(finish(again, assign));
}

TEST_F(Fencing, another_key_with_the_nonce_of_a_process_gets_nothing_of_it) {
  submit();
  const WorkerInfo rightful{.host = "host", .nonce = "n", .key = "its key"};
  worker_ = add_worker(rightful);
  const SendAssign assign = next(worker_);
  for (const bool is_restarted : {false, true}) {
    if (is_restarted) restart();
    for (const char* key : {"another key", ""}) {
      const WorkerInfo thief{.host = "host", .nonce = "n", .key = key};
      const WorkerId other = state_->add_worker(thief, assign.task, assign.attempt, now_);
      EXPECT_FALSE(std::get<SendWelcome>(state_->take_commands().front()).keep_running);
      EXPECT_FALSE(state_->holds(other, assign.task, assign.attempt));
      EXPECT_FALSE(finish(other, assign)) << "the result is another's";
      EXPECT_FALSE(fail(other, assign, {})) << "nor can it end it";
      EXPECT_EQ(state_->durable().running_attempts.count(assign.attempt), 1U);
    }
  }
  const WorkerId again = state_->add_worker(rightful, assign.task, assign.attempt, now_);
  EXPECT_TRUE(std::get<SendWelcome>(state_->take_commands().front()).keep_running);
  EXPECT_TRUE(finish(again, assign));
}

TEST_F(Fencing, of_a_nonce_only_a_hash_is_kept_with_the_key) {
  submit();
  const SendAssign assign = next(add_worker({.nonce = "abc", .key = "its key"}));
  const AttemptRow& row = record_.state().running_attempts.at(assign.attempt);
  EXPECT_EQ(row.key, "its key");
  EXPECT_EQ(row.nonce_hash, "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

TEST_F(Fencing, a_new_process_on_an_old_connection_does_not_inherit_its_attempt) {
  submit();
  worker_ = add_worker({.nonce = "first"});
  const SendAssign assign = next(worker_);
  state_->greet_again(worker_, {.nonce = "second"}, assign.task, assign.attempt, now_);
  EXPECT_FALSE(std::get<SendWelcome>(state_->take_commands().front()).keep_running);
  EXPECT_FALSE(finish(worker_, assign));
  EXPECT_EQ(task(assign.task).losses, 1U);
}

TEST_F(Fencing, a_result_of_an_attempt_that_another_worker_holds_is_refused) {
  submit();
  worker_ = new_worker();
  const SendAssign assign = next(worker_);
  const WorkerId other = new_worker();
  EXPECT_FALSE(finish(other, assign));
  EXPECT_FALSE(fail(other, assign, {}));
  EXPECT_EQ(task(assign.task).attempt, assign.attempt);
  EXPECT_TRUE(finish(worker_, assign));
}

TEST_F(Fencing, a_drained_worker_gets_nothing_more_and_is_told_again_when_it_asks) {
  submit();
  worker_ = new_worker();
  const WorkerId other = new_worker();
  EXPECT_EQ(state_->drain(WorkerId{99}), 0U);
  EXPECT_EQ(state_->drain(worker_), 1U);
  state_->take_commands();
  state_->worker_is_ready(worker_, now_);
  state_->tick(now_);
  const std::vector<Command> commands = state_->take_commands();
  ASSERT_THAT(commands, SizeIs(1));
  EXPECT_EQ(std::get<SendDrain>(commands.front()).worker, worker_);
  EXPECT_TRUE(next(other).attempt);
  EXPECT_EQ(state_->drain({}), 2U);
}

class Expectations : public JobStateTest {
 protected:
  /// A job with its cuts made, of which one mesh took so long and so much.
  void mesh_one(double seconds, std::uint64_t bytes) {
    submit();
    worker_ = new_worker();
    run_until_meshes();
    TaskResult result = run_fake_task(task(held_.task));
    for (const ArtifactRef& file : result.outputs) files_.insert(file.hash);
    result.seconds = seconds;
    result.peak_rss_bytes = bytes;
    state_->done(worker_, held_.task, held_.attempt, result, now_);
    commit();
    run_to_kind(TaskKind::mesh);
    state_->worker_left(worker_, false, now_);  // hands back the mesh that it holds
    commit();
  }
  /// Until the worker holds a task of that kind.
  void run_to_kind(TaskKind kind) {
    for (held_ = next(worker_); held_.attempt && task(held_.task).kind != kind;
         held_ = next(worker_)) {
      ASSERT_TRUE(finish(worker_, held_));
    }
    ASSERT_TRUE(held_.attempt);
  }
  double expected_seconds(TaskId id) {
    TaskExpectation expectation;
    for (const auto& [task, row] : state_->durable().tasks) {
      if (row.state == TaskState::done) expectation.learn(row);
    }
    return expectation.seconds(task(id)).value();
  }
  void wait_all(std::int64_t ms, std::initializer_list<std::pair<WorkerId, SendAssign>> busy) {
    now_.steady_ms += ms;
    for (const auto& [worker, assign] : busy) {
      state_->heartbeat(worker, assign.task, assign.attempt, now_);
    }
  }
};

TEST_F(Expectations, a_worker_gets_no_task_that_is_expected_to_outlast_its_walltime) {
  mesh_one(100, 1);
  const SendAssign wanted = next(new_worker());
  ASSERT_EQ(task(wanted.task).kind, TaskKind::mesh);
  const double seconds = expected_seconds(wanted.task);
  ASSERT_GT(seconds, 1);
  const auto in_ms = static_cast<std::int64_t>(seconds * 1000);
  EXPECT_FALSE(next(add_worker({.ends_in_ms = in_ms / 1000})).attempt);
  EXPECT_TRUE(next(add_worker({.ends_in_ms = in_ms * 1000})).attempt);
}

TEST_F(Expectations, explain_says_that_no_worker_stays_as_long_as_a_task_takes) {
  mesh_one(100, 1);
  const SendAssign wanted = next(new_worker());
  for (const WorkerAtWork& worker : state_->workers_at_work()) {
    state_->worker_left(worker.row.id, false, now_);
  }
  EXPECT_FALSE(next(add_worker({.ends_in_ms = 10})).attempt);
  EXPECT_THAT(state_->outlook(wanted.task, now_).reasons,
              testing::Contains(testing::HasSubstr(
                  "no worker stays for longer than another 1 s: start workers with a longer")));
}

TEST_F(Expectations, the_limit_of_an_attempt_follows_what_its_kind_took) {
  rules_.least_limit_ms = 1000;
  restart();
  mesh_one(100, 1);
  const SendAssign assign = next(new_worker());
  const double seconds = expected_seconds(assign.task);
  EXPECT_EQ(assign.limit_ms,
            std::max<std::int64_t>(
                1000, rules_.limit_factor * static_cast<std::int64_t>(seconds * 1000)));
}

TEST_F(Expectations, where_nothing_is_known_the_limit_is_a_day) {
  submit();
  EXPECT_EQ(next(new_worker()).limit_ms, rules_.unknown_limit_ms);
}

class Races : public Expectations {
 protected:
  /// All meshes but one are done; the one that is left takes its time on `slow_`.
  void leave_one_late() {
    mesh_one(1, 1);
    slow_ = add_worker({.host = "slow", .nonce = "slow"});
    first_ = next(slow_);
    ASSERT_EQ(task(first_.task).kind, TaskKind::mesh);
    worker_ = new_worker();
    for (SendAssign assign = next(worker_); assign.attempt; assign = next(worker_)) {
      ASSERT_TRUE(finish(worker_, assign));
      state_->heartbeat(slow_, first_.task, first_.attempt, now_);
    }
    state_->worker_left(worker_, false, now_);
    for (int i = 0; i < 40; ++i) {
      wait_all(rules_.lease_ms / 2, {{slow_, first_}});
      commit();
    }
    fast_ = add_worker({.host = "fast", .nonce = "fast"});
    second_ = next(fast_);
  }

  WorkerId slow_;
  WorkerId fast_;
  SendAssign first_;
  SendAssign second_;
};

TEST_F(Races, a_late_task_is_raced_when_nothing_else_is_ready_and_the_first_result_wins) {
  leave_one_late();
  ASSERT_EQ(second_.task, first_.task);
  EXPECT_NE(second_.attempt, first_.attempt);
  const WorkerId third = add_worker({.host = "third"});
  EXPECT_FALSE(next(third).attempt) << "one rival is enough";
  state_->worker_left(third, false, now_);
  EXPECT_TRUE(finish(fast_, second_));
  EXPECT_EQ(task(first_.task).attempt, second_.attempt);
  EXPECT_FALSE(finish(slow_, first_)) << "the slower result is not taken";
  EXPECT_EQ(task(first_.task).crashes + task(first_.task).losses, 0U);
  worker_ = fast_;
  run_all();
  EXPECT_EQ(job().phase, JobPhase::done);
}

TEST_F(Races, the_slower_worker_is_told_to_end) {
  leave_one_late();
  const TaskResult result = run_fake_task(task(first_.task));
  for (const ArtifactRef& file : result.outputs) files_.insert(file.hash);
  state_->done(slow_, first_.task, first_.attempt, result, now_);
  bool told = false;
  for (const Command& command : state_->take_commands()) {
    const auto* accepted = std::get_if<SendAccepted>(&command);
    if (accepted != nullptr && accepted->worker == fast_) told = !accepted->taken;
  }
  EXPECT_TRUE(told);
  commit();
}

TEST_F(Races, either_may_be_lost_and_the_other_goes_on) {
  leave_one_late();
  state_->worker_left(slow_, true, now_);
  commit();
  EXPECT_EQ(task(first_.task).state, TaskState::leased);
  restart();
  const WorkerId again = state_->add_worker({.nonce = "fast"}, second_.task, second_.attempt, now_);
  EXPECT_TRUE(finish(again, second_));
}

TEST_F(Races, a_race_goes_on_after_a_restart) {
  leave_one_late();
  restart();
  EXPECT_THAT(state_->validate(), IsEmpty());
  const WorkerId fast = state_->add_worker({.nonce = "fast"}, second_.task, second_.attempt, now_);
  const WorkerId slow = state_->add_worker({.nonce = "slow"}, first_.task, first_.attempt, now_);
  EXPECT_TRUE(finish(slow, first_));
  EXPECT_FALSE(finish(fast, second_));
}

TEST_F(Races, a_cancelled_job_ends_both) {
  leave_one_late();
  EXPECT_TRUE(state_->cancel(JobId{1}, now_));
  commit();
  EXPECT_TRUE(state_->durable().running_attempts.empty());
}

}  // namespace
}  // namespace tetfarm
