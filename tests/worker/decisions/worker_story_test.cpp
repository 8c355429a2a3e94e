// Everything that a worker does and writes into its log, in order, and when it wants to be woken.
#include <gmock/gmock.h>

#include <cerrno>

#include "base/error.h"
#include "tasks/failure_cause.h"
#include "worker/decisions/worker_state.h"

namespace tetfarm {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

struct Worded {
  std::string operator()(const ConnectAnew&) const { return "connect"; }
  std::string operator()(const SayHello& one) const {
    return "hello " + one.hello.ShortDebugString();
  }
  std::string operator()(const SendMessage& one) const {
    return "send " + one.envelope.ShortDebugString();
  }
  std::string operator()(const LookForRoom&) const { return "look for room"; }
  std::string operator()(const FetchInputs& one) const {
    return "fetch for " + std::to_string(one.assign.attempt());
  }
  std::string operator()(const StartChild& one) const {
    return "start " + std::to_string(one.assign.attempt()) +
           (one.is_without_shared_store ? " apart" : "");
  }
  std::string operator()(const EndOverdueChild& one) const {
    return "end overdue after " + std::to_string(one.limit_ms);
  }
  std::string operator()(const EndChild&) const { return "end"; }
  std::string operator()(const UploadOutputs& one) const {
    return "upload " + one.outcome.ShortDebugString();
  }
  std::string operator()(const AskForFilesAgain&) const { return "ask for files again"; }
  std::string operator()(const ForgetFiles&) const { return "forget files"; }
  std::string operator()(const TellLog& one) const {
    return (one.is_warning ? "warn: " : "log: ") + one.text;
  }
  std::string operator()(const ExitWorker& one) const {
    return one.is_refused ? "exit, refused: " + one.reason : "exit";
  }
};

class WorkerStory : public testing::Test {
 protected:
  std::vector<std::string> does() {
    std::vector<std::string> lines;
    for (const WorkerCommand& command : state_.take_commands()) {
      lines.push_back(std::visit(Worded{}, command));
    }
    return lines;
  }
  static wire::Hello self() {
    wire::Hello hello;
    hello.set_host("node-1");
    return hello;
  }
  void welcome(bool keep_running, bool sees_store) {
    wire::Envelope message;
    message.mutable_welcome()->set_heartbeat_ms(1000);
    message.mutable_welcome()->set_lease_ms(10'000);
    message.mutable_welcome()->set_keep_running(keep_running);
    message.mutable_welcome()->set_sees_store(sees_store);
    state_.hear(message, now_);
  }
  void assign(std::uint32_t kind = 3, std::uint64_t limit_ms = 0) {
    wire::Envelope message;
    wire::Assign& assign = *message.mutable_assign();
    assign.set_task(5);
    assign.set_attempt(7);
    assign.set_job("job-2");
    assign.set_kind(kind);
    assign.set_path(6);
    assign.set_limit_ms(limit_ms);
    state_.hear(message, now_);
  }
  void accept(bool taken) {
    wire::Envelope message;
    message.mutable_accepted()->set_task(5);
    message.mutable_accepted()->set_attempt(7);
    message.mutable_accepted()->set_taken(taken);
    state_.hear(message, now_);
  }
  static wire::Envelope done() {
    wire::Envelope envelope;
    envelope.mutable_done()->set_task(5);
    envelope.mutable_done()->set_attempt(7);
    return envelope;
  }
  /// Welcome, with nothing of that left to be done.
  void settle(bool sees_store = true) {
    welcome(false, sees_store);
    does();
  }

  std::int64_t now_ = 100'000;
  WorkerState state_{self(), {.ends_ms = 0, .grace_ms = 30'000, .cache = "/tmp/cache"}, now_};
};

TEST_F(WorkerStory, of_a_task_in_a_shared_store) {
  EXPECT_THAT(does(), ElementsAre("connect", "hello host: \"node-1\""));
  EXPECT_EQ(state_.due_ms(), now_ + 20) << "it says hello again";
  welcome(false, true);
  EXPECT_THAT(does(), ElementsAre("ask for files again", "send ready { }"));
  assign();
  EXPECT_THAT(does(), ElementsAre("log: job-2 task 5 attempt 7: mesh 6", "start 7"));
  state_.child_ended(done(), now_);
  EXPECT_THAT(does(), ElementsAre("send done { task: 5 attempt: 7 }", "send ready { }"));
  accept(true);
  EXPECT_THAT(does(), ElementsAre("forget files"));
}

TEST_F(WorkerStory, of_a_task_whose_files_go_over_the_connection) {
  does();
  welcome(false, false);
  EXPECT_THAT(does(), ElementsAre("log: files are transferred over the connection and kept in "
                                  "/tmp/cache",
                                  "ask for files again", "look for room"));
  state_.room_was_looked_for(false, now_);
  EXPECT_THAT(does(), IsEmpty());
  now_ += 1000;
  state_.tick(now_);
  EXPECT_THAT(does(), ElementsAre("look for room", "send heartbeat { }"));
  state_.room_was_looked_for(true, now_);
  EXPECT_THAT(does(), ElementsAre("send ready { }"));
  assign(77);
  EXPECT_THAT(does(), ElementsAre("log: job-2 task 5 attempt 7: unknown kind 6", "fetch for 7"));
  state_.inputs_came(now_);
  EXPECT_THAT(does(), ElementsAre("start 7 apart"));
  state_.child_ended(done(), now_);
  EXPECT_THAT(does(), ElementsAre("upload done { task: 5 attempt: 7 }"));
  state_.outputs_went(now_);
  EXPECT_THAT(does(), ElementsAre("send done { task: 5 attempt: 7 }"))
      << "it looks for room before it asks for another";
  accept(true);
  EXPECT_THAT(does(), ElementsAre("forget files", "look for room"));
}

TEST_F(WorkerStory, of_failures_has_who_is_to_blame) {
  settle();
  assign();
  does();
  state_.child_did_not_start(IoError("cannot start a process", "tetfarm", EAGAIN), now_);
  EXPECT_THAT(
      does(),
      ElementsAre("forget files",
                  "send failed { task: 5 attempt: 7 exit_code: 1 message: \"tetfarm: cannot "
                  "start a process: Resource temporarily unavailable\" cause: 2 }"));
  accept(true);
  does();
  assign();
  does();
  state_.child_did_not_start(IoError("cannot write", "x", ENOSPC), now_);
  EXPECT_THAT(does().back(), testing::HasSubstr("exit_code: 6")) << "of everybody's disk";
  accept(true);
  does();
  assign();
  does();
  wire::Envelope failed;
  failed.mutable_failed()->set_task(5);
  failed.mutable_failed()->set_attempt(7);
  failed.mutable_failed()->set_message("the surface is open");
  failed.mutable_failed()->set_cause(1);
  state_.child_ended(failed, now_);
  EXPECT_THAT(does(), ElementsAre("warn: task 5 attempt 7: the surface is open",
                                  "send failed { task: 5 attempt: 7 message: \"the surface is "
                                  "open\" cause: 1 }"));
}

TEST_F(WorkerStory, of_inputs_that_cannot_be_had_names_them) {
  settle(false);
  state_.room_was_looked_for(true, now_);
  assign();
  does();
  state_.input_is_damaged("0123", now_);
  EXPECT_THAT(does(), ElementsAre("forget files",
                                  "send failed { task: 5 attempt: 7 exit_code: 1 message: \"the "
                                  "coordinator has no intact copy of file 0123\" damaged_inputs: "
                                  "\"0123\" cause: 6 }"));
}

TEST_F(WorkerStory, of_attempts_that_nobody_wants_any_longer) {
  settle();
  assign();
  does();
  accept(false);
  EXPECT_THAT(does(), ElementsAre("log: task 5 attempt 7 is stale", "end", "forget files",
                                  "send ready { }"));
  assign();
  does();
  now_ += 10'000;
  state_.tick(now_);
  does();
  now_ += 1;
  state_.tick(now_);
  EXPECT_THAT(does(), ElementsAre("warn: the coordinator is silent; reconnecting", "connect",
                                  "hello host: \"node-1\" running_task: 5 running_attempt: 7"));
  welcome(false, true);
  EXPECT_THAT(does(), ElementsAre("log: task 5 attempt 7 is no longer wanted", "end",
                                  "forget files", "ask for files again", "send ready { }"));
}

TEST_F(WorkerStory, of_its_end_says_whether_a_task_is_running) {
  settle();
  assign();
  does();
  state_.signal_came(now_);
  EXPECT_THAT(does(), ElementsAre("log: draining: a task is running"));
  now_ += 9'000;
  state_.tick(now_);
  does();
  welcome(true, true);
  does();
  now_ += 9'000;
  state_.tick(now_);
  does();
  welcome(true, true);
  does();
  now_ += 9'000;
  state_.tick(now_);
  does();
  EXPECT_EQ(state_.due_ms(), now_ + 1'000);
  welcome(true, true);
  does();
  now_ += 3'000;
  state_.tick(now_);
  EXPECT_THAT(does(), ElementsAre("log: handing back task 5 attempt 7", "end", "forget files",
                                  "send goodbye { }", "exit"));
}

TEST_F(WorkerStory, of_a_refusal_ends_with_its_reason) {
  does();
  wire::Envelope refused;
  refused.mutable_refused()->set_reason("there are already 5 workers");
  state_.hear(refused, now_);
  EXPECT_THAT(does(), ElementsAre("exit, refused: there are already 5 workers"));
  EXPECT_EQ(state_.due_ms(), WorkerState::never_ms);
  state_.tick(now_ + 1'000'000);
  EXPECT_THAT(does(), IsEmpty());
}

TEST_F(WorkerStory, of_an_overdue_task_names_its_limit) {
  settle();
  assign(3, 4000);
  does();
  state_.tick(now_);
  does();
  EXPECT_EQ(state_.due_ms(), now_ + 1000) << "the next heartbeat";
  for (int i = 0; i < 4; ++i) {
    now_ += 1000;
    state_.tick(now_);
    EXPECT_THAT(does(), ElementsAre("send heartbeat { task: 5 attempt: 7 }"));
  }
  EXPECT_EQ(state_.due_ms(), now_ + 1) << "then it is overdue";
  now_ += 1;
  state_.tick(now_);
  EXPECT_THAT(does(), ElementsAre("end overdue after 4000"));
}

TEST_F(WorkerStory, of_a_walltime_that_is_nearly_over) {
  WorkerState state(self(), {.ends_ms = now_ + 40'000, .grace_ms = 30'000, .cache = ""}, now_);
  const auto words = [&state] {
    std::vector<std::string> lines;
    for (const WorkerCommand& command : state.take_commands()) {
      lines.push_back(std::visit(Worded{}, command));
    }
    return lines;
  };
  EXPECT_THAT(words(), ElementsAre("connect", "hello host: \"node-1\" ends_in_ms: 40000"));
  state.tick(now_ + 9'999);
  words();
  state.tick(now_ + 10'000);
  EXPECT_THAT(words(), ElementsAre("log: this worker's time is nearly up", "log: draining",
                                   "send goodbye { }", "exit"));
}

}  // namespace
}  // namespace tetfarm
