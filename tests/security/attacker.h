/// The attacker's tools: ZeroMQ peers under any key that say anything, and TCP connections without
/// ZeroMQ. What the coordinator answers to any of them is kept, so that a test can look for
/// secrets.
///
/// Everything is bounded in time: nothing here waits longer than it is told.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>
#include <zmq.hpp>

#include "proto/peer_security.h"
#include "proto/wire.h"

namespace tetfarm::test {

constexpr int patience_ms = 20'000;  ///< for what must come
constexpr int deaf_ms = 250;         ///< for what must not come

/// All bytes that anybody of this process was answered.
std::string& heard_bytes();

/// A ZeroMQ peer that is no program of ours.
class RawPeer {
 public:
  struct Manner {
    zmq::socket_type type = zmq::socket_type::dealer;
    std::string routing_id;  ///< "": one that ZeroMQ makes up
  };
  RawPeer(const std::string& endpoint, const std::optional<PeerKeys>& keys);
  RawPeer(const std::string& endpoint, const std::optional<PeerKeys>& keys, const Manner& manner);

  /// One message of these frames; false when it could not leave for a second.
  bool send_frames(const std::vector<std::string>& frames);
  bool send_bytes(const std::string& bytes) { return send_frames({bytes}); }
  bool send(const wire::Envelope& envelope);
  /// The next message that is no heartbeat; nothing when none comes.
  std::optional<wire::Envelope> hear(int wait_ms = patience_ms);
  /// The answer; an empty message, and a failure of the test, when there is none.
  wire::Envelope ask(const wire::Envelope& envelope);
  bool hears_nothing() { return !hear(deaf_ms); }
  zmq::socket_t& socket() { return socket_; }

 private:
  zmq::context_t context_;
  zmq::socket_t socket_;
};

/// A TCP connection to a port of this host.
class RawConnection {
 public:
  explicit RawConnection(int port);
  ~RawConnection() { close(); }
  RawConnection(RawConnection&& other) noexcept
      : descriptor_(std::exchange(other.descriptor_, -1)) {}
  RawConnection(const RawConnection&) = delete;
  RawConnection& operator=(const RawConnection&) = delete;
  RawConnection& operator=(RawConnection&&) = delete;

  bool is_open() const { return descriptor_ >= 0; }
  /// False when the other side has cut the connection off, or reads nothing for a second.
  bool send(const std::string& bytes) const;
  void end_sending() const;
  /// What comes until the other side closes, or nothing comes for so long.
  std::string hear(int wait_ms = patience_ms) const;
  /// Whether the other side closes within that time.
  bool is_cut_off(int wait_ms = patience_ms) const;
  void close();

 private:
  int descriptor_;
};

/// The number behind the last ':' of "tcp://127.0.0.1:5555".
int port_of(const std::string& address);

/// What a client says on the wire: `converse` gets the address of a listener that passes everything
/// on to `endpoint` and back. The client must have closed its connection when `converse` returns.
std::string recorded_conversation(const std::string& endpoint,
                                  const std::function<void(const std::string&)>& converse);

}  // namespace tetfarm::test
