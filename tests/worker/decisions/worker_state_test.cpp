#include "worker/decisions/worker_state.h"
#include "tasks/failure_cause.h"

#include <gmock/gmock.h>

#include <string>
#include <vector>

namespace tetfarm {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using Body = wire::Envelope::BodyCase;

constexpr std::int64_t heartbeat = 1'000;
constexpr std::int64_t lease = 10'000;
constexpr std::int64_t grace = 30'000;

/// A command in a word: the message that is sent, or what is to be done.
std::string word_of(const WorkerCommand& command) {
  if (const auto* send = std::get_if<SendMessage>(&command)) {
    switch (send->envelope.body_case()) {
      case Body::kReady:
        return "ready";
      case Body::kGoodbye:
        return "goodbye";
      case Body::kHeartbeat:
        return "heartbeat";
      case Body::kDone:
        return "done";
      case Body::kFailed:
        return "failed";
      default:
        return "another message";
    }
  }
  if (std::holds_alternative<ConnectAnew>(command)) return "connect";
  if (std::holds_alternative<SayHello>(command)) return "hello";
  if (std::holds_alternative<LookForRoom>(command)) return "look for room";
  if (std::holds_alternative<FetchInputs>(command)) return "fetch";
  if (std::holds_alternative<StartChild>(command)) return "start";
  if (std::holds_alternative<EndOverdueChild>(command)) return "end overdue";
  if (std::holds_alternative<EndChild>(command)) return "end";
  if (std::holds_alternative<UploadOutputs>(command)) return "upload";
  if (std::holds_alternative<ExitWorker>(command)) return "exit";
  return "";  // what is told to the log, or forgotten of files, is no decision
}

/// A worker of which each test says what happens to it, and looks at what it does.
class WorkerStateTest : public testing::Test {
 protected:
  ~WorkerStateTest() override { EXPECT_THAT(state_.validate(), IsEmpty()); }

  static wire::Hello self() {
    wire::Hello hello;
    hello.set_host("host");
    hello.set_nonce("nonce");
    return hello;
  }

  /// What it wants done since the last call.
  std::vector<std::string> does() {
    EXPECT_THAT(state_.validate(), IsEmpty());
    commands_ = state_.take_commands();
    std::vector<std::string> words;
    for (const WorkerCommand& command : commands_) {
      if (std::string word = word_of(command); !word.empty()) words.push_back(std::move(word));
    }
    return words;
  }
  template <class Command>
  const Command& last() const {
    for (auto command = commands_.rbegin(); command != commands_.rend(); ++command) {
      if (const auto* found = std::get_if<Command>(&*command)) return *found;
    }
    ADD_FAILURE() << "it does no such thing";
    static const Command nothing{};
    return nothing;
  }
  /// The last message of that kind which it sends.
  wire::Envelope said(Body body) const {
    for (auto command = commands_.rbegin(); command != commands_.rend(); ++command) {
      const auto* send = std::get_if<SendMessage>(&*command);
      if (send != nullptr && send->envelope.body_case() == body) return send->envelope;
    }
    ADD_FAILURE() << "it does not say so";
    return {};
  }
  std::string log() const {
    std::string text;
    for (const WorkerCommand& command : commands_) {
      if (const auto* line = std::get_if<TellLog>(&command)) text += line->text + "\n";
    }
    return text;
  }

  void welcome(bool keep_running = false, bool sees_store = true) {
    wire::Envelope message;
    message.mutable_welcome()->set_heartbeat_ms(heartbeat);
    message.mutable_welcome()->set_lease_ms(lease);
    message.mutable_welcome()->set_keep_running(keep_running);
    message.mutable_welcome()->set_sees_store(sees_store);
    state_.hear(message, now_);
  }
  void assign(std::uint64_t task, std::uint64_t attempt, std::uint64_t limit_ms = 0) {
    wire::Envelope message;
    message.mutable_assign()->set_task(task);
    message.mutable_assign()->set_attempt(attempt);
    message.mutable_assign()->set_limit_ms(limit_ms);
    state_.hear(message, now_);
  }
  void accept(std::uint64_t task, std::uint64_t attempt, bool taken) {
    wire::Envelope message;
    message.mutable_accepted()->set_task(task);
    message.mutable_accepted()->set_attempt(attempt);
    message.mutable_accepted()->set_taken(taken);
    state_.hear(message, now_);
  }
  void refuse(bool hello_again) {
    wire::Envelope message;
    message.mutable_refused()->set_hello_again(hello_again);
    message.mutable_refused()->set_reason("for a reason");
    state_.hear(message, now_);
  }
  void say_drain() {
    wire::Envelope message;
    message.mutable_drain();
    state_.hear(message, now_);
  }
  void hear_heartbeat() {
    wire::Envelope message;
    message.mutable_heartbeat();
    state_.hear(message, now_);
  }
  static wire::Envelope done_message() {
    wire::Envelope message;
    message.mutable_done()->set_task(5);
    message.mutable_done()->set_attempt(9);
    return message;
  }
  static wire::Envelope failed_message() {
    wire::Envelope message;
    message.mutable_failed()->set_task(5);
    message.mutable_failed()->set_attempt(9);
    message.mutable_failed()->set_message("no luck");
    return message;
  }

  /// It is welcome, and runs attempt 9 of task 5.
  void run_task_5(std::uint64_t limit_ms = 0) {
    welcome();
    assign(5, 9, limit_ms);
    EXPECT_THAT(does(), ElementsAre("connect", "hello", "ready", "start"));
  }
  /// The same for one that does not see the store; its inputs come.
  void fetch_task_5() {
    welcome(false, false);
    state_.room_was_looked_for(true, now_);
    assign(5, 9);
    EXPECT_THAT(does(), ElementsAre("connect", "hello", "look for room", "ready", "fetch"));
  }
  void run_task_5_without_shared_store() {
    fetch_task_5();
    state_.inputs_came(now_);
    EXPECT_THAT(does(), ElementsAre("start"));
  }
  void wait(std::int64_t ms) {
    now_ += ms;
    state_.tick(now_);
  }
  /// In silence and without heartbeats, which `does` would show.
  void wait_and_hear(std::int64_t ms) {
    for (std::int64_t i = 0; i < ms; i += heartbeat) {
      now_ += std::min(heartbeat, ms - i);
      hear_heartbeat();
      state_.tick(now_);
    }
  }

  std::int64_t now_ = 1'000'000;
  WorkerTerms terms_{.grace_ms = grace, .cache = "/cache"};
  WorkerState state_{self(), terms_, now_};
  std::vector<WorkerCommand> commands_;
};

// ---- how it stands with the coordinator

TEST_F(WorkerStateTest, connects_and_says_hello_first) {
  EXPECT_THAT(does(), ElementsAre("connect", "hello"));
  EXPECT_EQ(last<SayHello>().hello.nonce(), "nonce");
  EXPECT_EQ(last<SayHello>().hello.running_attempt(), 0U);
  EXPECT_EQ(state_.link(), WorkerLink::greeting);
}

TEST_F(WorkerStateTest, says_hello_again_after_pauses_that_double_up_to_five_seconds) {
  does();
  std::vector<std::int64_t> pauses;
  for (std::int64_t said = now_; pauses.size() < 10;) {
    now_ = state_.due_ms();
    state_.tick(now_ - 1);
    EXPECT_THAT(does(), IsEmpty());
    state_.tick(now_);
    EXPECT_THAT(does(), ElementsAre("hello"));
    pauses.push_back(now_ - said);
    said = now_;
  }
  EXPECT_THAT(pauses, ElementsAre(20, 40, 80, 160, 320, 640, 1'280, 2'560, 5'000, 5'000));
}

TEST_F(WorkerStateTest, a_hello_that_could_not_be_sent_is_said_as_soon_as_somebody_is_there) {
  does();
  state_.hello_was_not_sent();
  EXPECT_EQ(state_.link(), WorkerLink::unreachable);
  state_.connection_is_there(now_);
  EXPECT_THAT(does(), ElementsAre("hello"));
  EXPECT_EQ(state_.link(), WorkerLink::greeting);
  state_.connection_is_there(now_);
  EXPECT_THAT(does(), IsEmpty()) << "one that was sent needs no other";
}

TEST_F(WorkerStateTest, asks_for_work_when_it_is_welcome) {
  does();
  welcome();
  EXPECT_THAT(does(), ElementsAre("ready"));
  EXPECT_EQ(state_.link(), WorkerLink::registered);
}

TEST_F(WorkerStateTest, that_is_idle_asks_again_each_lease_should_its_ready_have_been_lost) {
  welcome();
  wait_and_hear(lease - 1);
  does();
  wait(1);
  EXPECT_THAT(does(), testing::Contains("ready"));
  wait_and_hear(lease - 1);
  EXPECT_THAT(does(), testing::Not(testing::Contains("ready")));
}

TEST_F(WorkerStateTest, whose_probe_was_swept_away_says_hello_and_does_not_ask) {
  does();
  state_.probe_was_swept_away(now_);
  EXPECT_THAT(does(), ElementsAre("hello"));
  EXPECT_EQ(state_.link(), WorkerLink::greeting);
}

TEST_F(WorkerStateTest, that_is_refused_for_good_says_why_and_does_nothing_any_more) {
  run_task_5();
  refuse(false);
  EXPECT_THAT(does(), ElementsAre("exit"));
  EXPECT_TRUE(last<ExitWorker>().is_refused);
  EXPECT_EQ(last<ExitWorker>().reason, "for a reason");
  EXPECT_EQ(state_.phase(), WorkerPhase::gone);
  welcome();
  state_.signal_came(now_);
  wait(100'000);
  EXPECT_THAT(does(), IsEmpty());
  EXPECT_EQ(state_.due_ms(), WorkerState::never_ms);
}

TEST_F(WorkerStateTest, presents_its_attempt_to_a_coordinator_that_does_not_know_it) {
  run_task_5();
  refuse(true);
  EXPECT_THAT(does(), ElementsAre("hello"));
  EXPECT_EQ(last<SayHello>().hello.running_task(), 5U);
  EXPECT_EQ(last<SayHello>().hello.running_attempt(), 9U);
  welcome(true);
  EXPECT_THAT(does(), IsEmpty());
  EXPECT_EQ(state_.phase(), WorkerPhase::running);
}

TEST_F(WorkerStateTest, ends_a_task_that_is_no_longer_wanted_and_asks_for_another) {
  run_task_5();
  refuse(true);
  does();
  welcome(false);
  EXPECT_THAT(does(), ElementsAre("end", "ready"));
  EXPECT_EQ(state_.phase(), WorkerPhase::idle);
}

TEST_F(WorkerStateTest, connects_anew_when_nothing_was_heard_for_more_than_a_lease) {
  run_task_5();
  wait(lease);
  EXPECT_THAT(does(), ElementsAre("heartbeat"));
  wait(1);
  EXPECT_THAT(does(), ElementsAre("connect", "hello"));
  EXPECT_EQ(last<SayHello>().hello.running_attempt(), 9U);
  EXPECT_EQ(state_.phase(), WorkerPhase::running) << "its task runs on";
}

TEST_F(WorkerStateTest, anything_that_is_heard_renews_the_lease) {
  run_task_5();
  wait(lease);
  hear_heartbeat();
  does();
  wait(1);
  EXPECT_THAT(does(), IsEmpty());
}

TEST_F(WorkerStateTest, heartbeats_name_the_attempt_and_what_it_does_and_nothing_when_idle) {
  welcome();
  does();
  wait(heartbeat);
  EXPECT_THAT(does(), ElementsAre("heartbeat"));
  EXPECT_EQ(said(Body::kHeartbeat).heartbeat().attempt(), 0U);
  assign(5, 9);
  wire::Doing doing;
  doing.set_stage("points");
  state_.child_does(doing);
  wait(heartbeat);
  EXPECT_THAT(does(), ElementsAre("start", "heartbeat"));
  EXPECT_EQ(said(Body::kHeartbeat).heartbeat().attempt(), 9U);
  EXPECT_EQ(said(Body::kHeartbeat).heartbeat().doing().stage(), "points");
  wait(heartbeat - 1);
  EXPECT_THAT(does(), IsEmpty());
}

// ---- its task

TEST_F(WorkerStateTest, runs_the_task_that_it_gets) {
  run_task_5();
  EXPECT_EQ(last<StartChild>().assign.attempt(), 9U);
  EXPECT_FALSE(last<StartChild>().is_without_shared_store);
  EXPECT_EQ(state_.phase(), WorkerPhase::running);
}

TEST_F(WorkerStateTest, that_holds_a_task_takes_no_other) {
  run_task_5();
  assign(6, 10);
  EXPECT_THAT(does(), IsEmpty());
  state_.child_ended(done_message(), now_);
  does();
  assign(6, 10);
  EXPECT_THAT(does(), IsEmpty()) << "nor while its result is not accepted";
}

TEST_F(WorkerStateTest, tells_a_result_and_asks_for_the_next_task_with_it) {
  run_task_5();
  state_.child_ended(done_message(), now_);
  EXPECT_THAT(does(), ElementsAre("done", "ready"));
  accept(5, 9, true);
  assign(6, 10);
  EXPECT_THAT(does(), ElementsAre("start"));
}

TEST_F(WorkerStateTest, says_that_ready_again_when_no_task_has_come_by_the_next_heartbeat) {
  run_task_5();
  state_.child_ended(done_message(), now_);
  accept(5, 9, true);
  wait(heartbeat - 1);
  does();
  wait(1);
  EXPECT_THAT(does(), testing::Contains("ready"));
}

TEST_F(WorkerStateTest, asks_for_another_task_only_when_a_failure_is_accepted) {
  run_task_5();
  state_.child_ended(failed_message(), now_);
  EXPECT_THAT(does(), ElementsAre("failed"));
  EXPECT_THAT(log(), HasSubstr("task 5 attempt 9: no luck"));
  accept(5, 9, true);
  EXPECT_THAT(does(), ElementsAre("ready"));
}

TEST_F(WorkerStateTest, repeats_a_result_each_second_until_it_is_accepted) {
  run_task_5();
  state_.child_ended(failed_message(), now_);
  does();
  wait(999);
  EXPECT_THAT(does(), ElementsAre("heartbeat"));
  wait(1);
  EXPECT_THAT(does(), testing::Contains("failed"));
}

TEST_F(WorkerStateTest, an_answer_for_another_attempt_or_task_changes_nothing) {
  run_task_5();
  state_.child_ended(done_message(), now_);
  does();
  accept(5, 8, true);
  accept(4, 9, true);
  accept(0, 0, false);
  EXPECT_THAT(does(), IsEmpty());
  EXPECT_EQ(state_.phase(), WorkerPhase::telling);
}

TEST_F(WorkerStateTest, an_attempt_that_is_stale_ends_and_one_that_runs_cannot_be_accepted) {
  run_task_5();
  accept(5, 9, true);
  EXPECT_THAT(does(), IsEmpty());
  EXPECT_EQ(state_.phase(), WorkerPhase::running);
  accept(5, 9, false);
  EXPECT_THAT(does(), ElementsAre("end", "ready"));
  EXPECT_THAT(log(), HasSubstr("is stale"));
}

TEST_F(WorkerStateTest, what_a_child_says_after_its_attempt_is_over_is_passed_over) {
  run_task_5();
  accept(5, 9, false);
  does();
  state_.child_ended(done_message(), now_);
  state_.child_did_not_start(Error(ExitCode::failed, "late"), now_);
  EXPECT_THAT(does(), IsEmpty());
  EXPECT_EQ(state_.phase(), WorkerPhase::idle);
}

TEST_F(WorkerStateTest, keeps_a_result_while_nobody_knows_it_and_tells_it_when_it_is_welcome) {
  run_task_5();
  refuse(true);
  does();
  state_.child_ended(done_message(), now_);
  EXPECT_THAT(does(), IsEmpty());
  welcome(true);
  EXPECT_THAT(does(), ElementsAre("done", "ready"));
}

TEST_F(WorkerStateTest, a_process_that_could_not_be_started_is_a_failure_of_the_world) {
  run_task_5();
  state_.child_did_not_start(Error(ExitCode::failed, "no process"), now_);
  EXPECT_THAT(does(), ElementsAre("failed"));
  const wire::Failed failed = said(Body::kFailed).failed();
  EXPECT_EQ(failed.attempt(), 9U);
  EXPECT_EQ(failed.message(), "no process");
  EXPECT_EQ(failed.cause(), on_wire(FailureCause::error));
}

TEST_F(WorkerStateTest, ends_a_task_once_it_takes_longer_than_its_limit_in_milliseconds) {
  run_task_5(2'500);
  wait_and_hear(2'500);
  EXPECT_THAT(does(), testing::Not(testing::Contains("end overdue")));
  wait(1);
  EXPECT_THAT(does(), ElementsAre("end overdue"));
  EXPECT_EQ(last<EndOverdueChild>().limit_ms, 2'500);
  EXPECT_EQ(state_.phase(), WorkerPhase::overdue);
  wait(1);
  EXPECT_THAT(does(), IsEmpty()) << "once";
  state_.child_ended(failed_message(), now_);
  EXPECT_THAT(does(), ElementsAre("failed"));
}

TEST_F(WorkerStateTest, a_task_without_a_limit_is_never_overdue) {
  run_task_5(0);
  wait_and_hear(std::int64_t{1'000'000});
  EXPECT_EQ(state_.phase(), WorkerPhase::running);
}

TEST_F(WorkerStateTest, the_limit_does_not_count_while_inputs_come) {
  welcome(false, false);
  assign(5, 9, 2'000);
  wait_and_hear(5'000);
  state_.inputs_came(now_);
  wait_and_hear(2'000);
  EXPECT_EQ(state_.phase(), WorkerPhase::running);
  wait(1);
  EXPECT_EQ(state_.phase(), WorkerPhase::overdue);
}

// ---- files of a task that runs without a shared store

TEST_F(WorkerStateTest, that_does_not_see_the_store_fetches_inputs_before_its_task_runs) {
  fetch_task_5();
  EXPECT_EQ(last<FetchInputs>().assign.task(), 5U);
  EXPECT_TRUE(state_.may_move_files());
  state_.inputs_came(now_);
  EXPECT_THAT(does(), ElementsAre("start"));
  EXPECT_TRUE(last<StartChild>().is_without_shared_store);
  EXPECT_FALSE(state_.may_move_files());
}

TEST_F(WorkerStateTest, says_once_that_files_are_transferred) {
  does();
  welcome(false, false);
  does();
  EXPECT_THAT(log(), HasSubstr("transferred over the connection and kept in /cache"));
  welcome(false, false);
  does();
  EXPECT_EQ(log(), "");
}

TEST_F(WorkerStateTest, sends_outputs_before_it_tells_the_result_and_asks_only_afterwards) {
  run_task_5_without_shared_store();
  state_.child_ended(done_message(), now_);
  EXPECT_THAT(does(), ElementsAre("upload"));
  EXPECT_TRUE(state_.may_move_files());
  wait(5'000);
  EXPECT_THAT(does(), ElementsAre("heartbeat"));
  state_.outputs_went(now_);
  EXPECT_THAT(does(), ElementsAre("done")) << "it looks for room before it asks";
  accept(5, 9, true);
  EXPECT_THAT(does(), ElementsAre("look for room"));
}

TEST_F(WorkerStateTest, moves_no_files_while_nobody_knows_it_and_asks_for_them_again_afterwards) {
  fetch_task_5();
  refuse(true);
  EXPECT_FALSE(state_.may_move_files());
  does();
  welcome(true, false);
  does();
  last<AskForFilesAgain>();
  EXPECT_TRUE(state_.may_move_files());
}

TEST_F(WorkerStateTest, looks_for_room_each_second_and_asks_when_there_is_some) {
  does();
  welcome(false, false);
  EXPECT_THAT(does(), ElementsAre("look for room"));
  state_.room_was_looked_for(false, now_);
  wait(999);
  EXPECT_THAT(does(), ElementsAre("heartbeat"));
  wait(1);
  EXPECT_THAT(does(), testing::Contains("look for room"));
  state_.room_was_looked_for(true, now_);
  EXPECT_THAT(does(), ElementsAre("ready"));
}

TEST_F(WorkerStateTest, a_damaged_input_is_named) {
  fetch_task_5();
  state_.input_is_damaged("0123", now_);
  EXPECT_THAT(does(), ElementsAre("failed"));
  const wire::Failed failed = said(Body::kFailed).failed();
  EXPECT_THAT(failed.damaged_inputs(), ElementsAre("0123"));
  EXPECT_EQ(failed.message(), "the coordinator has no intact copy of file 0123");
  EXPECT_EQ(state_.phase(), WorkerPhase::telling);
}

TEST_F(WorkerStateTest, forgets_the_files_of_an_attempt_that_failed_for_want_of_them) {
  fetch_task_5();
  does();
  state_.input_is_damaged("0123", now_);
  does();
  EXPECT_TRUE(std::ranges::any_of(commands_, [](const WorkerCommand& command) {
    return std::holds_alternative<ForgetFiles>(command);
  }));
}

TEST_F(WorkerStateTest, its_own_full_disk_is_not_that_of_all) {
  fetch_task_5();
  state_.files_failed(Error(ExitCode::out_of_resources, "no space"), false, now_);
  EXPECT_THAT(does(), ElementsAre("failed"));
  EXPECT_EQ(said(Body::kFailed).failed().cause(), on_wire(FailureCause::killed));
}

TEST_F(WorkerStateTest,
       a_full_disk_that_its_task_met_is_its_own_only_when_it_ran_without_a_shared_store) {
  wire::Envelope full = failed_message();
  full.mutable_failed()->set_cause(on_wire(FailureCause::disk_full));
  run_task_5_without_shared_store();
  state_.child_ended(full, now_);
  state_.outputs_went(now_);
  EXPECT_THAT(does(), ElementsAre("upload", "failed"));
  EXPECT_EQ(said(Body::kFailed).failed().cause(), on_wire(FailureCause::killed));
}

TEST_F(WorkerStateTest, a_full_disk_of_the_store_is_everybodys) {
  wire::Envelope full = failed_message();
  full.mutable_failed()->set_cause(on_wire(FailureCause::disk_full));
  run_task_5();
  state_.child_ended(full, now_);
  EXPECT_THAT(does(), ElementsAre("failed"));
  EXPECT_EQ(said(Body::kFailed).failed().cause(), on_wire(FailureCause::disk_full));
}

TEST_F(WorkerStateTest, a_disk_that_fails_under_its_files_is_no_full_one) {
  fetch_task_5();
  state_.files_failed(Error(ExitCode::failed, "input/output error"), false, now_);
  does();
  EXPECT_EQ(said(Body::kFailed).failed().cause(), on_wire(FailureCause::error));
}

TEST_F(WorkerStateTest, a_damaged_output_counts_as_if_the_task_had_been_killed) {
  run_task_5_without_shared_store();
  state_.child_ended(done_message(), now_);
  does();
  state_.files_failed(Error(ExitCode::failed, "damaged"), true, now_);
  EXPECT_THAT(does(), ElementsAre("failed")) << "instead of the result";
  EXPECT_EQ(said(Body::kFailed).failed().cause(), on_wire(FailureCause::killed));
  EXPECT_EQ(said(Body::kFailed).failed().attempt(), 9U);
}

TEST_F(WorkerStateTest, what_becomes_of_files_of_an_attempt_that_is_over_is_passed_over) {
  fetch_task_5();
  accept(5, 9, false);
  state_.room_was_looked_for(true, now_);
  does();
  state_.inputs_came(now_);
  state_.input_is_damaged("0123", now_);
  state_.outputs_went(now_);
  state_.files_failed(Error(ExitCode::failed, "late"), false, now_);
  EXPECT_THAT(does(), IsEmpty());
  EXPECT_EQ(state_.phase(), WorkerPhase::idle);
}

TEST_F(WorkerStateTest, what_it_sees_of_the_store_counts_from_the_next_task_on) {
  run_task_5();
  refuse(true);
  does();
  welcome(true, false);
  state_.child_ended(done_message(), now_);
  EXPECT_THAT(does(), ElementsAre("done")) << "no upload, and no asking without looking for room";
  EXPECT_FALSE(last<SendMessage>().envelope.has_ready());
  accept(5, 9, true);
  EXPECT_THAT(does(), ElementsAre("look for room"));
}

// ---- leaving

TEST_F(WorkerStateTest, that_holds_nothing_leaves_at_once) {
  welcome();
  does();
  state_.signal_came(now_);
  EXPECT_THAT(does(), ElementsAre("goodbye", "exit"));
  EXPECT_FALSE(last<ExitWorker>().is_refused);
  EXPECT_EQ(state_.phase(), WorkerPhase::gone);
}

TEST_F(WorkerStateTest, that_is_draining_finishes_its_task_and_leaves) {
  run_task_5();
  say_drain();
  EXPECT_THAT(does(), IsEmpty());
  state_.child_ended(done_message(), now_);
  EXPECT_THAT(does(), ElementsAre("done")) << "and does not ask for another";
  accept(5, 9, true);
  EXPECT_THAT(does(), ElementsAre("goodbye", "exit"));
}

TEST_F(WorkerStateTest, that_is_draining_takes_no_task_that_comes_with_the_answer) {
  run_task_5();
  state_.child_ended(done_message(), now_);
  EXPECT_THAT(does(), ElementsAre("done", "ready"));
  say_drain();
  accept(5, 9, true);
  assign(6, 10);
  EXPECT_THAT(does(), ElementsAre("goodbye", "exit"));
}

TEST_F(WorkerStateTest, hands_its_task_back_after_the_grace_time_and_not_before) {
  run_task_5();
  state_.signal_came(now_);
  wait_and_hear(grace - 1);
  EXPECT_EQ(state_.phase(), WorkerPhase::running);
  does();
  wait(1);
  EXPECT_THAT(does(), ElementsAre("end", "goodbye", "exit"));
  EXPECT_THAT(log(), HasSubstr("handing back task 5 attempt 9"));
}

TEST_F(WorkerStateTest, a_second_signal_hands_its_task_back_at_once) {
  run_task_5();
  state_.signal_came(now_);
  wait(1);
  EXPECT_THAT(does(), testing::Not(testing::Contains("end")));
  state_.signal_came(now_);
  wait(0);
  EXPECT_THAT(does(), ElementsAre("end", "goodbye", "exit"));
}

TEST_F(WorkerStateTest, being_asked_to_drain_once_more_gives_it_no_more_time_and_no_less) {
  run_task_5();
  state_.signal_came(now_);
  wait_and_hear(grace - 1);
  say_drain();
  state_.drain(now_);
  does();
  EXPECT_EQ(state_.phase(), WorkerPhase::running);
  wait(1);
  EXPECT_THAT(does(), ElementsAre("end", "goodbye", "exit"));
}

TEST_F(WorkerStateTest, drains_a_grace_time_before_its_batch_system_ends_it) {
  WorkerState state(self(), {.ends_ms = now_ + grace + 5'000, .grace_ms = grace}, now_);
  state.tick(now_ + 4'999);
  EXPECT_FALSE(state.is_draining());
  state.tick(now_ + 5'000);
  EXPECT_EQ(state.phase(), WorkerPhase::gone);
}

TEST_F(WorkerStateTest, tells_how_long_it_has_until_its_batch_system_ends_it) {
  WorkerState state(self(), {.ends_ms = now_ + 90'000, .grace_ms = grace}, now_);
  state.take_commands();
  state.probe_was_swept_away(now_ + 10'000);
  const std::vector<WorkerCommand> commands = state.take_commands();
  EXPECT_EQ(std::get<SayHello>(commands.front()).hello.ends_in_ms(), 80'000U);
}

TEST_F(WorkerStateTest, tick_has_done_what_was_due_and_says_when_it_is_due_next) {
  run_task_5(4'000);
  state_.tick(now_);
  EXPECT_THAT(does(), ElementsAre("heartbeat")) << "the first one at once";
  for (int i = 0; i < 40; ++i) {
    const std::int64_t due = state_.due_ms();
    ASSERT_GT(due, now_);
    now_ = due - 1;
    state_.tick(now_);
    ASSERT_THAT(does(), IsEmpty()) << "before it is due";
    now_ = due;
    state_.tick(now_);
    ASSERT_THAT(does(), testing::Not(IsEmpty()));
    if (i % 5 == 0) welcome(true);
    if (i == 20) state_.child_ended(failed_message(), now_);
    does();
  }
}

}  // namespace
}  // namespace tetfarm
