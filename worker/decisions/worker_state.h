/// The decisions of a worker: what it says, when it starts and ends its task, when it leaves.
///
/// A class without I/O and without a clock, as the coordinator's JobState is: events and the time
/// go in, commands come out, to be carried out in their order. worker/client.h is the shell around
/// it, and the simulation of a whole farm (tests/coordinator/simulated_farm.h) is another.
///
/// States and steps: worker/decisions/worker_phases.h, drawn in worker/decisions/worker_states.dot.
/// Messages: proto/protocol.md. It never gives up on the coordinator: when that is silent for a
/// lease the worker connects anew, and keeps its running task and any result that has not been
/// accepted. Invariants, checked by validate():
///  1. An attempt is held exactly in the phases from fetching to telling; its number is not 0.
///  2. A result is held exactly while its files go and until it is accepted, and names the attempt.
///  3. Files come and go only for a task that runs without the coordinator's store.
///  4. A draining worker that holds nothing is gone.
///  5. A worker that is gone does nothing any more.
/// Units: times in milliseconds, of a clock that never goes back.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "base/error.h"
#include "proto/messages.pb.h"
#include "worker/decisions/worker_phases.h"

namespace tetfarm {

// What the shell shall do. Where there is something to tell, it tells it as the event named here.
struct ConnectAnew {};
/// Names the mark that it leaves in the store, too, and may keep the message back until it knows
/// whether there is a store: it is said again. What cannot be sent: hello_was_not_sent().
struct SayHello {
  wire::Hello hello;
};
/// What does not arrive is said again: nothing depends on it.
struct SendMessage {
  wire::Envelope envelope;
};
/// For the files of a task that runs without the coordinator's store: room_was_looked_for().
struct LookForRoom {};
/// inputs_came(), input_is_damaged() or files_failed(), at once or later.
struct FetchInputs {
  wire::Assign assign;
};
/// child_did_not_start(), or child_does() and in the end child_ended().
struct StartChild {
  wire::Assign assign;
  bool is_without_shared_store = false;  ///< in the worker's own store
};
/// It took longer than it may; child_ended() follows.
struct EndOverdueChild {
  std::int64_t limit_ms = 0;
};
/// With what it has left; it is not heard of any more.
struct EndChild {};
/// outputs_went() or files_failed(), at once or later.
struct UploadOutputs {
  wire::Envelope outcome;
};
/// The connection is new: what was on the way is lost.
struct AskForFilesAgain {};
/// The attempt is over.
struct ForgetFiles {};
struct TellLog {
  std::string text;
  bool is_warning = false;
};
struct ExitWorker {
  bool is_refused = false;  ///< by the coordinator; otherwise it has drained
  std::string reason = {};
};
using WorkerCommand = std::variant<ConnectAnew, SayHello, SendMessage, LookForRoom, FetchInputs,
                                   StartChild, EndOverdueChild, EndChild, UploadOutputs,
                                   AskForFilesAgain, ForgetFiles, TellLog, ExitWorker>;

struct WorkerTerms {
  std::int64_t ends_ms = 0;        ///< when its batch system ends it; 0: not known
  std::int64_t grace_ms = 30'000;  ///< how long a running task may go on once it drains
  std::string cache = {};          ///< where files are kept that came over the connection
};

class WorkerState {
 public:
  static constexpr std::int64_t never_ms = std::numeric_limits<std::int64_t>::max();

  /// `self`: what it says of itself in each Hello. Its first commands connect it.
  WorkerState(wire::Hello self, const WorkerTerms& terms, std::int64_t now_ms);

  // The coordinator.
  void hear(const wire::Envelope& message, std::int64_t now_ms);
  void hello_was_not_sent();
  /// Somebody is at the other end.
  void connection_is_there(std::int64_t now_ms);
  /// What it left in the store for the coordinator to find is gone: the next Hello names another.
  void probe_was_swept_away(std::int64_t now_ms);

  // Its host. A signal asks it to drain; another hands its task back at once.
  void signal_came(std::int64_t now_ms);
  void drain(std::int64_t now_ms);
  /// Time passes. Call it every now and then, and when `due_ms` has come.
  void tick(std::int64_t now_ms);

  // Its task. What comes in a phase in which it is not waited for is passed over.
  void child_does(const wire::Doing& doing);
  void child_did_not_start(const Error& error, std::int64_t now_ms);
  /// With a Done or a Failed.
  void child_ended(wire::Envelope outcome, std::int64_t now_ms);

  // The files of a task that runs without the coordinator's store.
  void room_was_looked_for(bool has_room, std::int64_t now_ms);
  void inputs_came(std::int64_t now_ms);
  void input_is_damaged(const std::string& hash, std::int64_t now_ms);
  /// A damaged output is no fault of the task: it counts as if the task had been killed.
  void files_failed(const Error& error, bool output_is_damaged, std::int64_t now_ms);
  void outputs_went(std::int64_t now_ms);

  std::vector<WorkerCommand> take_commands();

  WorkerPhase phase() const { return phase_; }
  WorkerLink link() const { return link_; }
  bool is_draining() const { return drain_until_ms_.has_value(); }
  /// Whether files may be asked for and sent now.
  bool may_move_files() const;
  /// When tick() has something to do; never_ms: it has not.
  std::int64_t due_ms() const;

  /// The broken invariants, in words; empty when all is well.
  std::vector<std::string> validate() const;

 private:
  struct Attempt {
    wire::Assign assign;
    bool is_without_shared_store = false;
    std::int64_t started_ms = 0;
    wire::Doing doing;  ///< what its process said last
  };
  struct Result {
    wire::Envelope outcome;
    std::int64_t again_ms = 0;
    bool asks_for_next = false;  ///< it was said with a Ready
  };

  // What was heard.
  void take_welcome(const wire::Welcome& welcome, std::int64_t now_ms);
  void take_refused(const wire::Refused& refused, std::int64_t now_ms);
  void take_assign(const wire::Assign& assign, std::int64_t now_ms);
  void take_accepted(const wire::Accepted& accepted, std::int64_t now_ms);

  // What is said.
  void say_hello(std::int64_t now_ms);
  void say_ready(std::int64_t now_ms);
  void say_heartbeat(std::int64_t now_ms);
  void ask_or_leave(std::int64_t now_ms);
  void tell_result(std::int64_t now_ms);
  void send(wire::Envelope envelope) { commands_.push_back(SendMessage{std::move(envelope)}); }
  void log(std::string text, bool is_warning = false);

  // What becomes of the attempt.
  void start_child(std::int64_t now_ms);
  void fail(WorkerStep step, const Error& error, std::int64_t now_ms, wire::Failed how = {});
  void blame_own_disk(wire::Failed& failed) const;
  void release();
  void drain_until(std::int64_t until_ms, std::int64_t now_ms);
  bool is_running() const;
  bool has_overdue_child(std::int64_t now_ms) const;
  std::string attempt_name() const;

  void step(WorkerStep step);
  void step(LinkStep step);

  wire::Hello self_;
  WorkerTerms terms_;

  WorkerPhase phase_ = WorkerPhase::idle;
  std::optional<Attempt> attempt_;
  std::optional<Result> result_;
  std::optional<std::int64_t> drain_until_ms_;  ///< draining; when its task is handed back

  WorkerLink link_ = WorkerLink::greeting;
  bool sees_store_ = true;       ///< as the coordinator said last; counts from the next task on
  std::int64_t hello_pause_ms_;  ///< grows while nobody answers
  std::int64_t hello_ms_ = 0;    ///< when to say it again
  std::int64_t heard_ms_ = 0;    ///< the coordinator
  std::int64_t heartbeat_ms_ = 1'000;
  std::int64_t lease_ms_ = 10'000;
  std::int64_t beat_ms_ = 0;        ///< when the next heartbeat is due
  std::int64_t ask_ms_ = never_ms;  ///< when to say Ready again, or to look for room

  std::vector<WorkerCommand> commands_;
};

}  // namespace tetfarm
