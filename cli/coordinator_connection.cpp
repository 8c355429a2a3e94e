#include "cli/coordinator_connection.h"

#include <algorithm>
#include <zmq.hpp>

#include "base/check.h"
#include "base/clock.h"
#include "base/error.h"
#include "proto/address_family.h"
#include "proto/reconnection.h"
#include "proto/wire.h"
#include "tasks/inspect_contract.h"

namespace tetfarm {
namespace {

constexpr std::int64_t ask_again_ms = 1'000;
constexpr std::int64_t exchange_tick_ms = 100;

wire::Envelope::BodyCase answer_to(const wire::Envelope& question) {
  switch (question.body_case()) {
    case wire::Envelope::kSubmit:
      return wire::Envelope::kSubmitted;
    case wire::Envelope::kCancel:
      return wire::Envelope::kCancelled;
    case wire::Envelope::kSetPriority:
      return wire::Envelope::kPrioritySet;
    case wire::Envelope::kRetry:
      return wire::Envelope::kRetried;
    case wire::Envelope::kDrainWorkers:
      return wire::Envelope::kDraining;
    case wire::Envelope::kQuery:
      return wire::Envelope::kQueryReply;
    default:
      return wire::Envelope::kStatusReply;
  }
}

}  // namespace

struct CoordinatorConnection::Socket {
  zmq::context_t context{1};
  zmq::socket_t dealer{context, zmq::socket_type::dealer};
  HandshakeWatch handshakes{context, dealer};
};

CoordinatorConnection::CoordinatorConnection(const std::string& endpoint,
                                             const std::optional<PeerKeys>& keys)
    : endpoint_(endpoint), keys_(keys) {
  connect();
}

CoordinatorConnection::~CoordinatorConnection() = default;

void CoordinatorConnection::connect() {
  socket_ = std::make_unique<Socket>();
  socket_->dealer.set(zmq::sockopt::linger, 0);
  socket_->dealer.set(zmq::sockopt::immediate, 1);
  set_reconnection(socket_->dealer, endpoint_);
  socket_->dealer.set(zmq::sockopt::maxmsgsize, static_cast<std::int64_t>(max_message_size));
  secure(socket_->dealer, keys_);
  set_address_family(socket_->dealer, endpoint_, EndpointUse::connect);
  try {
    socket_->dealer.connect(endpoint_);
  } catch (const zmq::error_t& error) {
    throw UsageError(std::string("is not an address such as tcp://HOST:PORT: ") + error.what(),
                     endpoint_);
  }
}

/// @throws Error when trying again is of no use.
void CoordinatorConnection::check_handshake() {
  const HandshakeWatch::Outcome outcome = socket_->handshakes.take();
  if (outcome == HandshakeWatch::Outcome::none) return;
  trouble_ = "; " + socket_->handshakes.explanation_of(outcome);
  if (outcome == HandshakeWatch::Outcome::broken) return;
  throw Error(ExitCode::failed, endpoint_ + ": " + socket_->handshakes.explanation_of(outcome));
}

/// Nothing when `until` or a signal comes first, or what came says nothing.
/// @throws Error when it is a refusal.
std::optional<wire::Envelope> CoordinatorConnection::receive(std::int64_t until) {
  const std::int64_t left = std::max<std::int64_t>(0, until - steady_ms());
  socket_->dealer.set(zmq::sockopt::rcvtimeo, static_cast<int>(left));
  zmq::message_t message;
  try {
    if (!socket_->dealer.recv(message)) return std::nullopt;
  } catch (const zmq::error_t& error) {
    if (error.num() == EINTR) return std::nullopt;
    throw;
  }
  Decoded decoded = decode(message.to_string_view());
  if (decoded.envelope.has_refused()) {
    const int code = decoded.envelope.refused().exit_code();
    throw Error(code > 0 && code < 256 ? static_cast<ExitCode>(code) : ExitCode::failed,
                "the coordinator refused: " + decoded.envelope.refused().reason());
  }
  if (decoded.state != WireState::good) return wire::Envelope();
  return std::move(decoded.envelope);
}

/// The answer, or an Envelope without a body when `until` comes first.
wire::Envelope CoordinatorConnection::wait_for(wire::Envelope::BodyCase wanted,
                                               std::int64_t until) {
  while (true) {
    std::optional<wire::Envelope> message = receive(until);
    if (!message) return {};
    if (message->body_case() == wanted) return std::move(*message);
  }
}

wire::Envelope CoordinatorConnection::ask(const wire::Envelope& question, std::int64_t timeout_ms) {
  TF_CHECK(question.body_case() != wire::Envelope::BODY_NOT_SET);
  const std::int64_t until = steady_ms() + timeout_ms;
  const std::string bytes = encode(question);
  while (steady_ms() < until) {
    check_handshake();
    const std::int64_t again = std::min(until, steady_ms() + ask_again_ms);
    socket_->dealer.set(zmq::sockopt::sndtimeo, static_cast<int>(again - steady_ms()));
    try {
      if (!socket_->dealer.send(zmq::buffer(bytes))) continue;
    } catch (const zmq::error_t& error) {
      if (error.num() != EINTR) throw;
      continue;
    }
    wire::Envelope answer = wait_for(answer_to(question), again);
    if (answer.body_case() != wire::Envelope::BODY_NOT_SET) return answer;
  }
  check_handshake();
  throw NoAnswer(endpoint_ + ": no coordinator answers" + trouble_);
}

wire::StatusReply CoordinatorConnection::status(const std::string& job, std::int64_t timeout_ms) {
  wire::Envelope question;
  question.mutable_status_request()->set_job(job);
  wire::StatusReply all = ask(question, timeout_ms).status_reply();
  while (all.next() != 0) {
    question.mutable_status_request()->set_after(all.next());
    const wire::StatusReply page = ask(question, timeout_ms).status_reply();
    all.mutable_jobs()->MergeFrom(page.jobs());
    all.set_next(page.next());
  }
  return all;
}

wire::QueryReply CoordinatorConnection::query(const wire::Query& query, std::int64_t timeout_ms) {
  wire::Envelope question;
  *question.mutable_query() = query;
  return ask(question, timeout_ms).query_reply();
}

wire::StatusReply CoordinatorConnection::farm(std::int64_t timeout_ms) {
  wire::Envelope question;
  question.mutable_status_request()->set_farm_only(true);
  return ask(question, timeout_ms).status_reply();
}

wire::Submitted CoordinatorConnection::submit(const wire::Submit& submit, std::int64_t timeout_ms) {
  wire::Envelope question;
  *question.mutable_submit() = submit;
  return ask(question, timeout_ms).submitted();
}

wire::Cancelled CoordinatorConnection::cancel(const std::string& job, std::int64_t timeout_ms) {
  wire::Envelope question;
  question.mutable_cancel()->set_job(job);
  return ask(question, timeout_ms).cancelled();
}

wire::PrioritySet CoordinatorConnection::set_priority(const std::string& job, int priority,
                                                      std::int64_t timeout_ms) {
  wire::Envelope question;
  question.mutable_set_priority()->set_job(job);
  question.mutable_set_priority()->set_priority(priority);
  return ask(question, timeout_ms).priority_set();
}

wire::Retried CoordinatorConnection::retry(const wire::Retry& retry, std::int64_t timeout_ms) {
  wire::Envelope question;
  *question.mutable_retry() = retry;
  return ask(question, timeout_ms).retried();
}

wire::Draining CoordinatorConnection::drain(std::uint64_t worker, std::int64_t timeout_ms) {
  wire::Envelope question;
  question.mutable_drain_workers()->set_worker(worker);
  return ask(question, timeout_ms).draining();
}

/// False when there is no connection now.
bool CoordinatorConnection::send(const wire::Envelope& envelope) {
  const std::string bytes = encode(envelope);
  try {
    return socket_->dealer.send(zmq::buffer(bytes), zmq::send_flags::dontwait).has_value();
  } catch (const zmq::error_t& error) {
    if (error.num() == EINTR) return false;
    throw;
  }
}

void CoordinatorConnection::exchange(PieceExchange& files, std::int64_t timeout_ms,
                                     const std::function<void()>& moved) {
  std::int64_t moved_ms = steady_ms();
  std::int64_t connected_ms = moved_ms;
  while (!files.is_complete()) {
    check_handshake();
    for (const wire::Envelope& envelope : files.due(steady_ms())) {
      if (send(envelope)) continue;
      files.ask_again();
      break;
    }
    const std::optional<wire::Envelope> message = receive(steady_ms() + exchange_tick_ms);
    const std::int64_t now = steady_ms();
    if (message && files.take(*message, now)) {
      moved_ms = now;
      moved();
    } else if (now - moved_ms > timeout_ms) {
      throw Error(ExitCode::not_found, endpoint_ + ": no coordinator answers" + trouble_ +
                                           "; run the same command again to continue");
    } else if (now - std::max(moved_ms, connected_ms) > timeout_ms / 2) {
      connect();
      files.ask_again();
      connected_ms = now;
    }
  }
}

wire::Submit submission_of(const JobInput& input, const StoredArtifact& surface) {
  wire::Submit submit;
  submit.set_job_toml(to_toml(input.job));
  submit.set_name(input.job.name);
  submit.set_key(key_of(input));
  wire::Artifact& artifact = *submit.add_inputs();
  artifact.set_name(field_name(&InspectGiven::input_surface));
  artifact.set_hash(surface.hash);
  artifact.set_size(surface.size);
  return submit;
}

wire::Submit publish_job(const ArtifactStore& store, const JobInput& input) {
  check_submittable(input);
  return submission_of(input, store.publish(input.surface));
}

wire::Submit name_job(const JobInput& input) {
  check_submittable(input);
  wire::Submit submit;
  submit.set_job_toml(to_toml(input.job));
  submit.set_name(input.job.name);
  submit.set_surface_path(std::filesystem::absolute(input.path).string());
  return submit;
}

}  // namespace tetfarm
