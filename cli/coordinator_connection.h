/// A client's connection to a coordinator: asks and waits for the answer, asking again when it was
/// lost.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "cli/job_input.h"
#include "proto/messages.pb.h"
#include "proto/peer_security.h"
#include "store/artifact_store.h"

namespace tetfarm {

class CoordinatorConnection {
 public:
  /// Plain without keys. @throws UsageError for a malformed endpoint.
  explicit CoordinatorConnection(const std::string& endpoint,
                                 const std::optional<PeerKeys>& keys = std::nullopt);
  ~CoordinatorConnection();

  /// The jobs, one or ("") all. @throws Error (not_found) when no answer comes within timeout_ms,
  /// (failed) when the coordinator refuses.
  wire::StatusReply status(const std::string& job, std::int64_t timeout_ms);
  /// Who works, and what waits for workers; no jobs.
  wire::StatusReply farm(std::int64_t timeout_ms);
  /// One page. Otherwise as status().
  wire::QueryReply query(const wire::Query& query, std::int64_t timeout_ms);
  wire::Submitted submit(const wire::Submit& submit, std::int64_t timeout_ms);
  wire::Cancelled cancel(const std::string& job, std::int64_t timeout_ms);
  wire::Retried retry(const wire::Retry& retry, std::int64_t timeout_ms);
  wire::Draining drain(std::uint64_t worker, std::int64_t timeout_ms);

 private:
  wire::Envelope ask(const wire::Envelope& question, std::int64_t timeout_ms);
  void connect();
  void heed_handshake();
  wire::Envelope wait_for(wire::Envelope::BodyCase wanted, std::int64_t until);

  struct Socket;
  std::string endpoint_;
  std::optional<PeerKeys> keys_;
  std::string trouble_;  ///< with the last handshake
  std::unique_ptr<Socket> socket_;
};

/// Publishes the job's surface in the store, and the message that submits it.
wire::Submit publish_job(const ArtifactStore& store, const JobInput& input);

/// The message that submits a job whose surface the coordinator shall fetch itself.
wire::Submit name_job(const JobInput& input);

}  // namespace tetfarm
