/// Answers messages: finds out who speaks, lets job_state decide, words the replies.
///
/// It knows connections (ZeroMQ routing ids) and the store, but no socket: bytes go in, replies
/// come out, so that tests need no network. Nothing that arrives can end the daemon.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/error.h"
#include "coordinator/authenticator.h"
#include "coordinator/client_files.h"
#include "coordinator/damage_checks.h"
#include "coordinator/decisions/job_state.h"
#include "coordinator/file_transfers.h"
#include "coordinator/leftovers.h"
#include "coordinator/surface_roots.h"
#include "coordinator/views/refusals.h"
#include "proto/messages.pb.h"
#include "store/artifact_store.h"
#include "store/job_history.h"

namespace tetfarm {

struct HandlerOptions {
  std::int64_t heartbeat_ms = 1000;
  std::int64_t lease_ms = 10000;
  std::size_t max_workers = 10'000;
  std::string security = "plain";  ///< for StatusReply
  /// A submission may cancel all other jobs: a farm of one job, as `tetfarm run` starts it.
  bool may_replace_jobs = false;
  std::size_t jobs_per_user = 0;  ///< as of FarmRules, for what is said
};

/// A message to send to a connection.
struct Reply {
  std::string connection;
  wire::Envelope envelope;
  bool needs_commit = true;  ///< tells of something that must be durable first
};

/// Who sent a message, in words.
std::string who(const Sender& sender);

class RequestHandler {
 public:
  RequestHandler(const ArtifactStore& store, const SurfaceRoots& roots,
                 const HandlerOptions& options, Refusals& refusals)
      : store_(store), roots_(roots), options_(options), refusals_(refusals) {}

  /// Takes one message. What its sender may not say is refused; what cannot be read is dropped.
  /// Both are counted.
  void handle(const Sender& sender, std::string_view bytes, JobState& state, Moment now);

  /// A message that had not even the right number of parts.
  void drop(const Sender& sender, const std::string& why, Moment now);

  /// The list of authorised keys has changed: workers whose key is no worker's any longer lose
  /// what they hold.
  void expel(const Authenticator& authenticator, JobState& state, Moment now);

  /// Until open(): whoever wants something decided is refused with that reason, workers are not
  /// heard, as if nobody were here, and questions are answered.
  void close(const std::string& reason, ExitCode code);
  void open() { closed_.clear(); }
  bool is_closed() const { return !closed_.empty(); }

  void set_security(const std::string& security) { options_.security = security; }

  /// Turns what job_state wants sent into replies.
  void carry_out(JobState& state, Moment now);

  /// Answers the questions of viewers that came since the last call, with the state as it is:
  /// after a commit, or after a failed one once the state is again what the database holds.
  void answer_questions(const JobState& state, const JobHistory& history,
                        const Authenticator& authenticator, Moment now);

  /// What the thread of files shall do now: files of workers that do not see the store, and those
  /// of which a worker says that they are damaged.
  std::vector<FileOrder> take_file_orders(const JobState& state, Moment now);
  /// What those have left whom these changes, which are durable now, declare gone.
  std::vector<FileOrder> orders_after(const ChangeSet& changes) {
    return leftovers_.orders_after(changes);
  }
  /// Clients' surfaces that had begun to come before a restart.
  void remember_surfaces(const std::vector<BegunSurface>& begun, Moment now) {
    client_files_.remember(begun, now);
  }
  /// What became of one, but for what is to be said of it.
  void note_file(const FileAnswer& answer, JobState& state, Moment now);

  /// What is to be sent since the last call, of a turn that was not committed: without what would
  /// tell of something that is not durable. While this is closed, clients are refused instead.
  std::vector<Reply> take_replies_uncommitted();
  std::vector<Reply> take_replies();
  /// Troubles with files since the last call, for the log.
  std::vector<std::string> take_complaints();

  /// Whether heartbeats came since the last call, and nothing else.
  bool take_only_heartbeats() {
    const bool heard_other = std::exchange(heard_other_, false);
    return std::exchange(heard_heartbeat_, false) && !heard_other;
  }

  /// The worker of a connection; 0 when it has none.
  WorkerId worker_of(const std::string& connection) const;

  /// All workers are unknown again and will be asked to say Hello.
  void forget_workers();

 private:
  // request_handler.cpp: who speaks, and what it comes to
  void answer(const std::string& connection, wire::Envelope envelope, bool needs_commit = true);
  void refuse(const std::string& connection, const std::string& reason, ExitCode code);
  bool is_welcome(const Sender& sender, Moment now);
  void dispatch(const Sender& sender, const wire::Envelope& envelope, JobState& state, Moment now);
  void handle_worker(const std::string& connection, const wire::Envelope& envelope, JobState& state,
                     Moment now);
  void answer_heartbeat(const std::string& connection, const wire::Heartbeat& beat, Moment now);
  void hello(const Sender& sender, const wire::Hello& hello, JobState& state, Moment now);
  void files(const std::string& connection, WorkerId worker, const wire::Envelope& envelope,
             JobState& state, Moment now);
  bool sees_store(const wire::Hello& hello) const;
  void note_store(const std::string& connection, WorkerId worker, const wire::Hello& hello);
  void forget(WorkerId worker);
  void failed(WorkerId worker, const wire::Failed& message, JobState& state, Moment now);
  void submit(const Sender& sender, const wire::Submit& message, JobState& state, Moment now);
  Submission submission_of(const wire::Submit& message) const;
  void add_loop(const wire::Submit& message, Submission& submission) const;
  void refuse_one_too_many(const std::string& connection);
  void refuse_unmet(const std::string& connection, JobId unmet, const JobState& state);
  void set_priority(const std::string& connection, const wire::SetPriority& message,
                    JobState& state, Moment now);
  void retry(const std::string& connection, const wire::Retry& message, JobState& state,
             Moment now);
  // request_client_files.cpp: results for clients, surfaces of theirs
  void client_file(const Sender& sender, const wire::Envelope& envelope, const JobState& state,
                   Moment now);
  // request_replies.cpp: what was decided, put into words
  void send(const Command& command, const JobState& state, Moment now);
  void forget_lost_workers(const JobState& state);
  wire::StatusReply status_of_all(const wire::StatusRequest& request, const JobState& state,
                                  const Authenticator& authenticator, Moment now) const;

  struct Known {
    WorkerId worker;
    std::string key;  ///< with which it said Hello, "": none
    bool sees_store = true;
    std::int64_t answered_ms = 0;  ///< when one of its heartbeats was, for the last time
  };

  const ArtifactStore& store_;
  const SurfaceRoots& roots_;
  HandlerOptions options_;
  Refusals& refusals_;
  std::map<std::string, Known> workers_;  ///< by connection
  std::map<WorkerId, std::string> connections_;
  struct Question {
    std::string connection;
    wire::Envelope envelope;  ///< StatusRequest or Query
  };
  std::vector<Question> questions_;
  FileTransfers transfers_;
  ClientFiles client_files_;
  DamageChecks checks_;
  Leftovers leftovers_;
  bool heard_heartbeat_ = false;
  bool heard_other_ = false;
  std::string closed_;  ///< why; "": it is open
  ExitCode closed_code_ = ExitCode::failed;
  std::vector<Reply> replies_;
  std::vector<std::string> complaints_;
};

}  // namespace tetfarm
