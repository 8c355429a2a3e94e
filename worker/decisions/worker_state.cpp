#include "worker/decisions/worker_state.h"

#include <algorithm>
#include <utility>

#include "base/check.h"
#include "tasks/failure_cause.h"
#include "tasks/task_kind.h"

namespace tetfarm {
namespace {

constexpr std::int64_t first_hello_pause_ms = 20;
constexpr std::int64_t longest_hello_pause_ms = 5'000;
constexpr std::int64_t result_again_ms = 1'000;
constexpr std::int64_t room_again_ms = 1'000;
constexpr std::int64_t least_heartbeat_ms = 10;

}  // namespace

WorkerState::WorkerState(wire::Hello self, const WorkerTerms& terms, std::int64_t now_ms)
    : self_(std::move(self)), terms_(terms), hello_pause_ms_(first_hello_pause_ms) {
  commands_.push_back(ConnectAnew{});
  say_hello(now_ms);
}

std::vector<WorkerCommand> WorkerState::take_commands() { return std::exchange(commands_, {}); }

void WorkerState::step(WorkerStep step) {
  const std::optional<WorkerPhase> next = phase_after(phase_, step);
  TF_CHECK(next.has_value());
  phase_ = *next;
}

void WorkerState::step(LinkStep step) {
  const std::optional<WorkerLink> next = link_after(link_, step);
  TF_CHECK(next.has_value());
  link_ = *next;
}

void WorkerState::log(std::string text, bool is_warning) {
  commands_.push_back(TellLog{std::move(text), is_warning});
}

std::string WorkerState::attempt_name() const {
  return "task " + std::to_string(attempt_->assign.task()) + " attempt " +
         std::to_string(attempt_->assign.attempt());
}

// ---- the coordinator

void WorkerState::say_hello(std::int64_t now_ms) {
  hello_ms_ = now_ms + hello_pause_ms_;
  hello_pause_ms_ = std::min(2 * hello_pause_ms_, longest_hello_pause_ms);
  wire::Hello hello = self_;
  if (terms_.ends_ms > 0) {
    hello.set_ends_in_ms(
        static_cast<std::uint64_t>(std::max<std::int64_t>(1, terms_.ends_ms - now_ms)));
  }
  hello.set_running_task(attempt_ ? attempt_->assign.task() : 0);
  hello.set_running_attempt(attempt_ ? attempt_->assign.attempt() : 0);
  commands_.push_back(SayHello{std::move(hello)});
}

void WorkerState::hello_was_not_sent() {
  if (link_ == WorkerLink::greeting) step(LinkStep::not_sent);
}

void WorkerState::connection_is_there(std::int64_t now_ms) {
  if (link_ != WorkerLink::unreachable) return;
  step(LinkStep::connected);
  say_hello(now_ms);
}

void WorkerState::probe_was_swept_away(std::int64_t now_ms) {
  if (phase_ == WorkerPhase::gone) return;
  heard_ms_ = now_ms;
  step(LinkStep::forgotten);
  say_hello(now_ms);
}

void WorkerState::hear(const wire::Envelope& message, std::int64_t now_ms) {
  if (phase_ == WorkerPhase::gone) return;
  heard_ms_ = now_ms;
  switch (message.body_case()) {
    case wire::Envelope::kWelcome:
      return take_welcome(message.welcome(), now_ms);
    case wire::Envelope::kRefused:
      return take_refused(message.refused(), now_ms);
    case wire::Envelope::kAssign:
      return take_assign(message.assign(), now_ms);
    case wire::Envelope::kAccepted:
      return take_accepted(message.accepted(), now_ms);
    case wire::Envelope::kDrain:
      return drain_until(now_ms + terms_.grace_ms, now_ms);
    default:
      return;
  }
}

void WorkerState::take_welcome(const wire::Welcome& welcome, std::int64_t now_ms) {
  step(LinkStep::welcomed);
  if (sees_store_ && !welcome.sees_store()) {
    log("files are transferred over the connection and kept in " + terms_.cache);
  }
  sees_store_ = welcome.sees_store();
  hello_pause_ms_ = first_hello_pause_ms;
  heartbeat_ms_ = std::max<std::int64_t>(welcome.heartbeat_ms(), least_heartbeat_ms);
  lease_ms_ = std::max<std::int64_t>(welcome.lease_ms(), 2 * heartbeat_ms_);
  if (attempt_ && !welcome.keep_running()) {
    log(attempt_name() + " is no longer wanted");
    release();
  }
  commands_.push_back(AskForFilesAgain{});
  if (phase_ == WorkerPhase::telling) tell_result(now_ms);
  if (phase_ == WorkerPhase::idle) ask_or_leave(now_ms);
}

void WorkerState::take_refused(const wire::Refused& refused, std::int64_t now_ms) {
  if (!refused.hello_again()) {
    step(WorkerStep::refused);
    attempt_.reset();
    result_.reset();
    commands_.push_back(ExitWorker{true, refused.reason()});
    return;
  }
  step(LinkStep::forgotten);
  say_hello(now_ms);
}

/// Should it be lost, it is said again.
void WorkerState::say_ready(std::int64_t now_ms) {
  ask_ms_ = now_ms + lease_ms_;
  wire::Envelope envelope;
  envelope.mutable_ready();
  send(std::move(envelope));
}

/// Who has no room for a task's files waits until there is some.
void WorkerState::ask_or_leave(std::int64_t now_ms) {
  ask_ms_ = never_ms;
  if (is_draining()) {
    wire::Envelope envelope;
    envelope.mutable_goodbye();
    send(std::move(envelope));
    step(WorkerStep::left);
    commands_.push_back(ExitWorker{});
  } else if (sees_store_) {
    say_ready(now_ms);
  } else {
    commands_.push_back(LookForRoom{});
  }
}

void WorkerState::room_was_looked_for(bool has_room, std::int64_t now_ms) {
  if (phase_ != WorkerPhase::idle) return;
  if (has_room) return say_ready(now_ms);
  ask_ms_ = now_ms + room_again_ms;
}

void WorkerState::say_heartbeat(std::int64_t now_ms) {
  beat_ms_ = now_ms + heartbeat_ms_;
  wire::Envelope envelope;
  wire::Heartbeat& beat = *envelope.mutable_heartbeat();
  if (attempt_) {
    beat.set_task(attempt_->assign.task());
    beat.set_attempt(attempt_->assign.attempt());
  }
  if (is_running() && !attempt_->doing.stage().empty()) *beat.mutable_doing() = attempt_->doing;
  send(std::move(envelope));
}

// ---- the attempt

bool WorkerState::is_running() const {
  return phase_ == WorkerPhase::running || phase_ == WorkerPhase::overdue;
}

void WorkerState::take_assign(const wire::Assign& assign, std::int64_t now_ms) {
  if (phase_ != WorkerPhase::idle || assign.attempt() == 0) return;
  ask_ms_ = never_ms;
  attempt_ = Attempt{};
  attempt_->assign = assign;
  attempt_->is_without_shared_store = !sees_store_;
  const std::optional<TaskKind> kind = task_kind_on_wire(assign.kind());
  log(assign.job() + " " + attempt_name() + ": " + (kind ? name_of(*kind) : "unknown kind") + " " +
      std::to_string(assign.path()));
  step(attempt_->is_without_shared_store ? WorkerStep::assigned_without_shared_store
                                         : WorkerStep::assigned);
  if (!attempt_->is_without_shared_store) return start_child(now_ms);
  commands_.push_back(FetchInputs{attempt_->assign});
}

void WorkerState::inputs_came(std::int64_t now_ms) {
  if (phase_ != WorkerPhase::fetching) return;
  step(WorkerStep::inputs_came);
  start_child(now_ms);
}

void WorkerState::start_child(std::int64_t now_ms) {
  attempt_->started_ms = now_ms;
  commands_.push_back(StartChild{attempt_->assign, attempt_->is_without_shared_store});
}

void WorkerState::child_does(const wire::Doing& doing) {
  if (attempt_) attempt_->doing = doing;
}

void WorkerState::child_did_not_start(const Error& error, std::int64_t now_ms) {
  if (phase_ == WorkerPhase::running) fail(WorkerStep::start_failed, error, now_ms);
}

void WorkerState::input_is_damaged(const std::string& hash, std::int64_t now_ms) {
  if (phase_ != WorkerPhase::fetching) return;
  wire::Failed how;
  how.set_cause(on_wire(FailureCause::damaged_input));
  how.add_damaged_inputs(hash);
  const Error error(ExitCode::failed, "the coordinator has no intact copy of file " + hash);
  fail(WorkerStep::input_is_damaged, error, now_ms, std::move(how));
}

void WorkerState::files_failed(const Error& error, bool output_is_damaged, std::int64_t now_ms) {
  if (!phase_after(phase_, WorkerStep::files_failed)) return;
  wire::Failed how;
  if (output_is_damaged) how.set_cause(on_wire(FailureCause::killed));
  fail(WorkerStep::files_failed, error, now_ms, std::move(how));
}

/// The attempt ends here because of the world around it; `how` may have no cause.
void WorkerState::fail(WorkerStep step_taken, const Error& error, std::int64_t now_ms,
                       wire::Failed how) {
  step(step_taken);
  if (how.cause() == 0) {
    const bool is_full = error.code() == ExitCode::out_of_resources;
    how.set_cause(on_wire(is_full ? FailureCause::disk_full : FailureCause::error));
  }
  how.set_task(attempt_->assign.task());
  how.set_attempt(attempt_->assign.attempt());
  how.set_message(error.what());
  how.set_exit_code(static_cast<int>(error.code()));
  blame_own_disk(how);
  result_ = Result{};
  *result_->outcome.mutable_failed() = std::move(how);
  commands_.push_back(ForgetFiles{});
  tell_result(now_ms);
}

/// A full disk of this worker alone must not stop the others: the task goes elsewhere.
void WorkerState::blame_own_disk(wire::Failed& failed) const {
  if (!attempt_->is_without_shared_store || failed.cause() != on_wire(FailureCause::disk_full))
    return;
  failed.set_cause(on_wire(FailureCause::killed));
}

void WorkerState::child_ended(wire::Envelope outcome, std::int64_t now_ms) {
  if (!is_running()) return;
  step(attempt_->is_without_shared_store ? WorkerStep::child_ended_without_shared_store
                                         : WorkerStep::child_ended);
  if (outcome.has_failed()) {
    log(attempt_name() + ": " + outcome.failed().message(), true);
    blame_own_disk(*outcome.mutable_failed());
  }
  result_ = Result{};
  result_->outcome = std::move(outcome);
  if (phase_ == WorkerPhase::telling) return tell_result(now_ms);
  commands_.push_back(UploadOutputs{result_->outcome});
}

void WorkerState::outputs_went(std::int64_t now_ms) {
  if (phase_ != WorkerPhase::uploading) return;
  step(WorkerStep::outputs_went);
  tell_result(now_ms);
}

/// Until it is accepted. Who has done its task asks for the next one with the result, which then
/// comes with the answer, out of the same transaction.
void WorkerState::tell_result(std::int64_t now_ms) {
  result_->again_ms = now_ms + result_again_ms;
  if (link_ != WorkerLink::registered) return;
  send(result_->outcome);
  result_->asks_for_next = result_->outcome.has_done() && sees_store_ && !is_draining();
  if (result_->asks_for_next) say_ready(now_ms);
}

void WorkerState::take_accepted(const wire::Accepted& accepted, std::int64_t now_ms) {
  if (!attempt_ || accepted.attempt() != attempt_->assign.attempt() ||
      accepted.task() != attempt_->assign.task()) {
    return;
  }
  if (is_running() && accepted.taken()) return;
  if (!accepted.taken()) log(attempt_name() + " is stale");
  const bool waits_for_next = result_ && result_->asks_for_next && !is_draining();
  release();
  if (!waits_for_next) return ask_or_leave(now_ms);
  // Should that Ready have been lost, it is said again.
  ask_ms_ = now_ms + heartbeat_ms_;
}

void WorkerState::release() {
  if (is_running()) commands_.push_back(EndChild{});
  commands_.push_back(ForgetFiles{});
  step(WorkerStep::released);
  attempt_.reset();
  result_.reset();
}

bool WorkerState::may_move_files() const {
  return link_ == WorkerLink::registered &&
         (phase_ == WorkerPhase::fetching || phase_ == WorkerPhase::uploading);
}

// ---- time

void WorkerState::signal_came(std::int64_t now_ms) {
  drain_until(now_ms + (is_draining() ? 0 : terms_.grace_ms), now_ms);
}

void WorkerState::drain(std::int64_t now_ms) {
  if (!is_draining()) drain_until(now_ms + terms_.grace_ms, now_ms);
}

/// What asks a second time does not give it more time.
void WorkerState::drain_until(std::int64_t until_ms, std::int64_t now_ms) {
  if (phase_ == WorkerPhase::gone) return;
  log(attempt_ ? "draining: a task is running" : "draining");
  drain_until_ms_ = std::min(drain_until_ms_.value_or(until_ms), until_ms);
  if (phase_ == WorkerPhase::idle) ask_or_leave(now_ms);
}

bool WorkerState::has_overdue_child(std::int64_t now_ms) const {
  const auto limit_ms = static_cast<std::int64_t>(attempt_ ? attempt_->assign.limit_ms() : 0);
  return phase_ == WorkerPhase::running && limit_ms > 0 && now_ms - attempt_->started_ms > limit_ms;
}

void WorkerState::tick(std::int64_t now_ms) {
  if (phase_ == WorkerPhase::gone) return;
  if (!is_draining() && terms_.ends_ms > 0 && now_ms >= terms_.ends_ms - terms_.grace_ms) {
    log("this worker's time is nearly up");
    drain(now_ms);
    if (phase_ == WorkerPhase::gone) return;
  }
  if (is_draining() && now_ms >= *drain_until_ms_) {
    log("handing back " + attempt_name());
    release();
    return ask_or_leave(now_ms);
  }
  if (has_overdue_child(now_ms)) {
    step(WorkerStep::limit_passed);
    commands_.push_back(EndOverdueChild{static_cast<std::int64_t>(attempt_->assign.limit_ms())});
  }
  if (link_ != WorkerLink::registered) {
    if (now_ms < hello_ms_) return;
    step(LinkStep::again);
    return say_hello(now_ms);
  }
  if (now_ms - heard_ms_ > lease_ms_) {
    log("the coordinator is silent; reconnecting", true);
    step(LinkStep::silent);
    commands_.push_back(ConnectAnew{});
    return say_hello(now_ms);
  }
  if (phase_ == WorkerPhase::idle && now_ms >= ask_ms_) ask_or_leave(now_ms);
  if (now_ms >= beat_ms_) say_heartbeat(now_ms);
  if (phase_ == WorkerPhase::telling && now_ms >= result_->again_ms) tell_result(now_ms);
}

std::int64_t WorkerState::due_ms() const {
  if (phase_ == WorkerPhase::gone) return never_ms;
  std::int64_t due =
      link_ == WorkerLink::registered ? std::min(beat_ms_, heard_ms_ + lease_ms_ + 1) : hello_ms_;
  if (is_draining()) {
    due = std::min(due, *drain_until_ms_);
  } else if (terms_.ends_ms > 0) {
    due = std::min(due, terms_.ends_ms - terms_.grace_ms);
  }
  if (phase_ == WorkerPhase::running && attempt_->assign.limit_ms() > 0) {
    due = std::min(
        due, attempt_->started_ms + static_cast<std::int64_t>(attempt_->assign.limit_ms()) + 1);
  }
  if (link_ != WorkerLink::registered) return due;
  if (phase_ == WorkerPhase::idle) due = std::min(due, ask_ms_);
  if (phase_ == WorkerPhase::telling) due = std::min(due, result_->again_ms);
  return due;
}

std::vector<std::string> WorkerState::validate() const {
  std::vector<std::string> broken;
  const bool holds = phase_ != WorkerPhase::idle && phase_ != WorkerPhase::gone;
  const bool moves_files = phase_ == WorkerPhase::fetching || phase_ == WorkerPhase::uploading;
  const bool has_result = phase_ == WorkerPhase::uploading || phase_ == WorkerPhase::telling;
  const std::string in = std::string("1 to 5, in phase ") + name_of(phase_) + ": ";
  if (attempt_.has_value() != holds) broken.push_back(in + "an attempt is held, or is not");
  if (attempt_ && attempt_->assign.attempt() == 0) broken.push_back(in + "its number is 0");
  if (result_.has_value() != has_result) broken.push_back(in + "a result is held, or is not");
  if (moves_files && !attempt_->is_without_shared_store)
    broken.push_back(in + "files move in a shared store");
  if (phase_ == WorkerPhase::idle && is_draining()) broken.push_back(in + "a draining idle worker");
  return broken;
}

}  // namespace tetfarm
