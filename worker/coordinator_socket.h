/// A worker's connection to its coordinator: keys, handshakes, messages. It can be made anew at any
/// time; whatever was on the way is then lost, which the protocol does not mind.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <zmq.hpp>

#include "proto/messages.pb.h"
#include "proto/peer_security.h"

namespace tetfarm {

class CoordinatorSocket {
 public:
  /// Is not connected yet. `store` may be empty, see read_peer_keys.
  CoordinatorSocket(std::string endpoint, KeyFiles keys, std::filesystem::path store);

  /// Also anew. Reads the keys again. @throws UsageError, IoError: see read_peer_keys.
  void connect();
  /// A broken handshake is tried again: the coordinator may just have been ended.
  /// @throws Error when trying again does not help.
  void check_handshake();
  /// Without waiting; what cannot be sent now is lost: false.
  bool send(const wire::Envelope& envelope);
  /// The next message that is sound, or refuses; nothing when no more has come.
  std::optional<wire::Envelope> receive();
  /// `waits_to_send`: is ready, with ZMQ_POLLOUT, also when there is a connection to send over.
  zmq::pollitem_t poll_item(bool waits_to_send) const {
    const int events = waits_to_send ? ZMQ_POLLIN | ZMQ_POLLOUT : ZMQ_POLLIN;
    return {socket_->handle(), 0, static_cast<short>(events), 0};
  }

 private:
  const std::string endpoint_;
  const KeyFiles keys_;
  const std::filesystem::path store_;
  zmq::context_t context_{1};
  std::unique_ptr<zmq::socket_t> socket_;
  std::optional<HandshakeWatch> handshakes_;  // goes before its socket
  std::uint64_t broken_handshakes_ = 0;
};

}  // namespace tetfarm
