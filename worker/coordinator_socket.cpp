#include "worker/coordinator_socket.h"

#include <spdlog/spdlog.h>

#include <bit>
#include <utility>

#include "base/check.h"
#include "base/error.h"
#include "proto/address_family.h"
#include "proto/reconnection.h"
#include "proto/wire.h"

namespace tetfarm {
namespace {

constexpr int linger_ms = 500;

}  // namespace

CoordinatorSocket::CoordinatorSocket(std::string endpoint, KeyFiles keys,
                                     std::filesystem::path store)
    : endpoint_(std::move(endpoint)), keys_(std::move(keys)), store_(std::move(store)) {}

void CoordinatorSocket::connect() {
  handshakes_.reset();
  socket_ = std::make_unique<zmq::socket_t>(context_, zmq::socket_type::dealer);
  socket_->set(zmq::sockopt::linger, linger_ms);
  socket_->set(zmq::sockopt::immediate, 1);
  socket_->set(zmq::sockopt::maxmsgsize, static_cast<std::int64_t>(max_message_size));
  set_reconnection(*socket_, endpoint_);
  secure(*socket_, read_peer_keys(keys_, store_));
  handshakes_.emplace(context_, *socket_);
  set_address_family(*socket_, endpoint_, EndpointUse::connect);
  socket_->connect(endpoint_);
}

void CoordinatorSocket::check_handshake() {
  TF_CHECK(handshakes_.has_value());
  const HandshakeWatch::Outcome outcome = handshakes_->take();
  if (outcome == HandshakeWatch::Outcome::none) return;
  if (outcome != HandshakeWatch::Outcome::broken) {
    throw Error(ExitCode::failed, endpoint_ + ": " + handshakes_->explanation_of(outcome));
  }
  if (std::has_single_bit(++broken_handshakes_)) {
    spdlog::warn("{}: {}", endpoint_, handshakes_->explanation_of(outcome));
  }
}

bool CoordinatorSocket::send(const wire::Envelope& envelope) {
  TF_CHECK(socket_ != nullptr);
  const std::string bytes = encode(envelope);
  return socket_->send(zmq::buffer(bytes), zmq::send_flags::dontwait).has_value();
}

std::optional<wire::Envelope> CoordinatorSocket::receive() {
  TF_CHECK(socket_ != nullptr);
  zmq::message_t message;
  while (socket_->recv(message, zmq::recv_flags::dontwait)) {
    Decoded decoded = decode(message.to_string_view());
    if (decoded.state == WireState::good || decoded.envelope.has_refused()) {
      return std::move(decoded.envelope);
    }
  }
  return std::nullopt;
}

}  // namespace tetfarm
