/// Answers messages: finds out who speaks, lets job_state decide, words the replies.
///
/// It knows connections (ZeroMQ routing ids) and the store, but no socket: bytes go in, replies
/// come out, so that tests need no network. Nothing that arrives can end the daemon.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "coordinator/job_state.h"
#include "proto/messages.pb.h"
#include "store/artifact_store.h"

namespace tetfarm {

struct HandlerOptions {
  std::int64_t heartbeat_ms = 1000;
  std::int64_t lease_ms = 10000;
};

/// A message to send to a connection.
struct Reply {
  std::string connection;
  wire::Envelope envelope;
  bool needs_commit = true;  ///< tells of something that must be durable first
};

class RequestHandler {
 public:
  RequestHandler(const ArtifactStore& store, const HandlerOptions& options)
      : store_(store), options_(options) {}

  /// Takes one message. Unreadable and senseless ones are counted and dropped.
  void handle(const std::string& connection, std::string_view bytes, JobState& state, Moment now);

  /// A message that had not even the right number of parts.
  void drop(const std::string& connection, const std::string& why);

  /// Turns what job_state wants sent into replies.
  void carry_out(JobState& state);

  /// Answers the questions for a status that came since the last call, with the state as it is:
  /// after a commit, or after a failed one once the state is again what the database holds.
  void answer_questions(const JobState& state, Moment now);

  std::vector<Reply> take_replies();
  /// Complaints about messages since the last call, for the log; bounded.
  std::vector<std::string> take_complaints();
  std::uint64_t dropped() const { return dropped_; }

  /// The worker of a connection; 0 when it has none.
  WorkerId worker_of(const std::string& connection) const;

  /// All workers are unknown again and will be asked to say Hello.
  void forget_workers();

 private:
  void answer(const std::string& connection, wire::Envelope envelope, bool needs_commit = true);
  void handle_worker(const std::string& connection, const wire::Envelope& envelope, JobState& state,
                     Moment now);
  void hello(const std::string& connection, const wire::Hello& hello, JobState& state, Moment now);
  void failed(WorkerId worker, const wire::Failed& message, JobState& state, Moment now);
  void submit(const std::string& connection, const wire::Submit& message, JobState& state,
              Moment now);
  bool is_damaged(const ArtifactRef& file);
  void send(const Command& command, const JobState& state);

  const ArtifactStore& store_;
  HandlerOptions options_;
  std::map<std::string, WorkerId> workers_;
  std::map<WorkerId, std::string> connections_;
  struct Question {
    std::string connection;
    std::string job;  ///< empty: all
  };
  std::vector<Question> questions_;
  std::vector<Reply> replies_;
  std::vector<std::string> complaints_;
  std::uint64_t dropped_ = 0;
};

}  // namespace tetfarm
