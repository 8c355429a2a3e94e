#include "proto/peer_security.h"

#include <algorithm>
#include <cstdint>
#include <cstring>

#include "base/check.h"
#include "base/error.h"
#include "base/file_system.h"
#include "base/ids.h"

namespace tetfarm {

struct HandshakeWatch::Ears {
  zmq::socket_t& watched;
  zmq::socket_t pair;
};

std::filesystem::path published_key_path(const std::filesystem::path& store) {
  return store / "coordinator.pub";
}

std::optional<PeerKeys> read_peer_keys(const KeyFiles& files, const std::filesystem::path& store) {
  if (files.own.empty()) {
    if (files.coordinator.empty()) return std::nullopt;
    throw UsageError("is of use only together with a key of your own: add --key",
                     "--coordinator-key");
  }
  PeerKeys keys{read_secret_key(files.own), {}};
  if (!files.coordinator.empty()) {
    keys.coordinator = read_public_key(files.coordinator);
  } else if (!store.empty() && size_of_file(published_key_path(store))) {
    keys.coordinator = read_public_key(published_key_path(store));
  } else {
    throw UsageError("is missing; --key needs the coordinator's public key too",
                     "--coordinator-key");
  }
  return keys;
}

void secure(zmq::socket_t& socket, const std::optional<PeerKeys>& keys) {
  if (!keys) return;
  TF_CHECK(keys->own.secret_bytes.size() == 32 && !keys->coordinator.bytes.empty());
  const auto set = [&socket](int option, const std::string& bytes) {
    if (zmq_setsockopt(socket.handle(), option, bytes.data(), bytes.size()) != 0) {
      throw Error(ExitCode::failed,
                  std::string("cannot use the key: ") + zmq_strerror(zmq_errno()));
    }
  };
  set(ZMQ_CURVE_SERVERKEY, keys->coordinator.bytes);
  set(ZMQ_CURVE_PUBLICKEY, keys->own.public_key.bytes);
  set(ZMQ_CURVE_SECRETKEY, keys->own.secret_bytes);
}

HandshakeWatch::HandshakeWatch(zmq::context_t& context, zmq::socket_t& socket)
    : ears_(new Ears{socket, zmq::socket_t(context, zmq::socket_type::pair)}) {
  const std::string address = "inproc://handshakes-" + random_hex(8);
  zmq_socket_monitor(socket.handle(), address.c_str(),
                     ZMQ_EVENT_HANDSHAKE_FAILED_NO_DETAIL | ZMQ_EVENT_HANDSHAKE_FAILED_PROTOCOL |
                         ZMQ_EVENT_HANDSHAKE_FAILED_AUTH);
  ears_->pair.set(zmq::sockopt::linger, 0);
  // Whoever tells of an event must never have to wait for us: it holds a lock of the socket.
  ears_->pair.set(zmq::sockopt::rcvhwm, 0);
  ears_->pair.connect(address);
}

HandshakeWatch::~HandshakeWatch() { zmq_socket_monitor(ears_->watched.handle(), nullptr, 0); }

HandshakeWatch::Outcome HandshakeWatch::take() {
  Outcome worst = Outcome::none;
  zmq::message_t event;
  while (ears_->pair.recv(event, zmq::recv_flags::dontwait)) {
    if (!event.more() || event.size() != 6) continue;  // the other frame is an address
    std::uint16_t kind = 0;
    std::uint32_t value = 0;
    std::memcpy(&kind, event.data(), sizeof kind);
    std::memcpy(&value, static_cast<const char*>(event.data()) + sizeof kind, sizeof value);
    Outcome outcome = Outcome::broken;
    if (kind == ZMQ_EVENT_HANDSHAKE_FAILED_AUTH) outcome = Outcome::turned_away;
    if (kind == ZMQ_EVENT_HANDSHAKE_FAILED_PROTOCOL &&
        value == ZMQ_PROTOCOL_ERROR_ZMTP_MECHANISM_MISMATCH) {
      outcome = Outcome::other_kind;
    }
    worst = std::max(worst, outcome);
  }
  return worst;
}

std::string HandshakeWatch::explanation_of(Outcome outcome) const {
  const bool has_key = ears_->watched.get(zmq::sockopt::mechanism) == ZMQ_CURVE;
  switch (outcome) {
    case Outcome::none:
      return "";
    case Outcome::broken:
      return has_key
                 ? "the connection was cut off: is --coordinator-key the key of this coordinator?"
                 : "the connection was cut off; perhaps this coordinator requires a key: --key";
    case Outcome::turned_away:
      return "this coordinator has not authorised the key: `tetfarm keys authorize`";
    case Outcome::other_kind:
      return has_key ? "this coordinator uses no keys: leave out --key"
                     : "this coordinator requires a key: --key";
  }
  return "";
}

}  // namespace tetfarm
