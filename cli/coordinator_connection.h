/// A client's connection to a coordinator: asks and waits for the answer, asking again when it was
/// lost.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cli/job_input.h"
#include "proto/messages.pb.h"
#include "proto/peer_security.h"
#include "store/artifact_store.h"

namespace tetfarm {

/// Files that travel in pieces: says what to send, and is told what came.
class PieceExchange {
 public:
  virtual ~PieceExchange() = default;
  virtual bool is_complete() const = 0;
  /// What to send now. @throws IoError.
  virtual std::vector<wire::Envelope> due(std::int64_t now_ms) = 0;
  /// Whether it moved on. @throws IoError.
  virtual bool take(const wire::Envelope& message, std::int64_t now_ms) = 0;
  /// What is under way is lost.
  virtual void ask_again() = 0;
};

class CoordinatorConnection {
 public:
  /// Plain without keys. @throws UsageError for a malformed endpoint.
  explicit CoordinatorConnection(const std::string& endpoint,
                                 const std::optional<PeerKeys>& keys = std::nullopt);
  ~CoordinatorConnection();

  /// The jobs, one or ("") all. @throws NoAnswer when no answer comes within timeout_ms, Error
  /// (failed) when the coordinator refuses.
  wire::StatusReply status(const std::string& job, std::int64_t timeout_ms);
  /// Who works, and what waits for workers; no jobs.
  wire::StatusReply farm(std::int64_t timeout_ms);
  /// One page. Otherwise as status().
  wire::QueryReply query(const wire::Query& query, std::int64_t timeout_ms);
  wire::Submitted submit(const wire::Submit& submit, std::int64_t timeout_ms);
  wire::Cancelled cancel(const std::string& job, std::int64_t timeout_ms);
  wire::PrioritySet set_priority(const std::string& job, int priority, std::int64_t timeout_ms);
  wire::Retried retry(const wire::Retry& retry, std::int64_t timeout_ms);
  wire::Draining drain(std::uint64_t worker, std::int64_t timeout_ms);
  /// Until it is complete; connects anew when the connection is cut. `moved` is called now and
  /// then. @throws Error (not_found) when nothing comes for timeout_ms, otherwise as status().
  void exchange(PieceExchange& files, std::int64_t timeout_ms, const std::function<void()>& moved);

 private:
  wire::Envelope ask(const wire::Envelope& question, std::int64_t timeout_ms);
  void connect();
  void check_handshake();
  std::optional<wire::Envelope> receive(std::int64_t until);
  bool send(const wire::Envelope& envelope);
  wire::Envelope wait_for(wire::Envelope::BodyCase wanted, std::int64_t until);

  struct Socket;
  std::string endpoint_;
  std::optional<PeerKeys> keys_;
  std::string trouble_;  ///< with the last handshake
  std::unique_ptr<Socket> socket_;
};

/// Publishes the job's surface in the store, and the message that submits it.
wire::Submit publish_job(const ArtifactStore& store, const JobInput& input);

/// The message that submits a job whose surface is in the store under this name.
wire::Submit submission_of(const JobInput& input, const StoredArtifact& surface);

/// The message that submits a job whose surface the coordinator shall read itself.
wire::Submit name_job(const JobInput& input);

}  // namespace tetfarm
