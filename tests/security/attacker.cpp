#include "tests/security/attacker.h"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <thread>

namespace tetfarm::test {
namespace {

constexpr int leave_ms = 1'000;

sockaddr_in loopback(int port) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = ::htonl(INADDR_LOOPBACK);
  address.sin_port = ::htons(static_cast<std::uint16_t>(port));
  return address;
}

int connected(int port) {
  const int descriptor = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  const sockaddr_in address = loopback(port);
  if (::connect(descriptor, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0) {
    return descriptor;
  }
  ::close(descriptor);
  return -1;
}

/// Passes bytes both ways until one side closes. What the first said.
std::string pass_on(int client, int server) {
  std::string said;
  std::array<pollfd, 2> both = {{{client, POLLIN, 0}, {server, POLLIN, 0}}};
  std::string bytes(65536, '\0');
  while (::poll(both.data(), both.size(), patience_ms) > 0) {
    const bool from_client = both[0].revents != 0;
    const ssize_t count = ::recv(from_client ? client : server, bytes.data(), bytes.size(), 0);
    if (count <= 0) break;
    const auto size = static_cast<std::size_t>(count);
    if (from_client) said.append(bytes, 0, size);
    ::send(from_client ? server : client, bytes.data(), size, MSG_NOSIGNAL);
  }
  ::close(client);
  ::close(server);
  return said;
}

}  // namespace

std::string& heard_bytes() {
  static std::string bytes;
  return bytes;
}

RawPeer::RawPeer(const std::string& endpoint, const std::optional<PeerKeys>& keys)
    : RawPeer(endpoint, keys, Manner{}) {}

RawPeer::RawPeer(const std::string& endpoint, const std::optional<PeerKeys>& keys,
                 const Manner& manner)
    : socket_(context_, manner.type) {
  if (!manner.routing_id.empty()) socket_.set(zmq::sockopt::routing_id, manner.routing_id);
  secure(socket_, keys);
  socket_.set(zmq::sockopt::linger, 0);
  socket_.set(zmq::sockopt::sndtimeo, leave_ms);
  socket_.set(zmq::sockopt::reconnect_ivl, 10);
  socket_.connect(endpoint);
}

bool RawPeer::send_frames(const std::vector<std::string>& frames) {
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const auto more = i + 1 < frames.size() ? zmq::send_flags::sndmore : zmq::send_flags::none;
    if (!socket_.send(zmq::buffer(frames[i]), more)) return false;
  }
  return true;
}

bool RawPeer::send(const wire::Envelope& envelope) { return send_bytes(encode(envelope)); }

std::optional<wire::Envelope> RawPeer::hear(int wait_ms) {
  const auto until = std::chrono::steady_clock::now() + std::chrono::milliseconds(wait_ms);
  while (true) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(
        until - std::chrono::steady_clock::now());
    zmq::pollitem_t item{socket_.handle(), 0, ZMQ_POLLIN, 0};
    if (left.count() < 0 || zmq::poll(&item, 1, left) == 0) return std::nullopt;
    zmq::message_t message;
    if (!socket_.recv(message)) return std::nullopt;
    heard_bytes().append(message.to_string_view());
    Decoded decoded = decode(message.to_string_view());
    EXPECT_EQ(decoded.state, WireState::good);
    if (!decoded.envelope.has_heartbeat()) return std::move(decoded.envelope);
  }
}

wire::Envelope RawPeer::ask(const wire::Envelope& envelope) {
  EXPECT_TRUE(send(envelope));
  std::optional<wire::Envelope> answer = hear();
  if (!answer) ADD_FAILURE() << "no answer to " << envelope.ShortDebugString().substr(0, 200);
  return answer.value_or(wire::Envelope{});
}

RawConnection::RawConnection(int port) : descriptor_(connected(port)) {}

bool RawConnection::send(const std::string& bytes) const {
  std::size_t sent = 0;
  while (sent < bytes.size()) {
    pollfd ready{descriptor_, POLLOUT, 0};
    if (::poll(&ready, 1, leave_ms) <= 0) return false;
    const ssize_t count =
        ::send(descriptor_, bytes.data() + sent, bytes.size() - sent, MSG_NOSIGNAL | MSG_DONTWAIT);
    if (count <= 0) return false;
    sent += static_cast<std::size_t>(count);
  }
  return true;
}

void RawConnection::end_sending() const { ::shutdown(descriptor_, SHUT_WR); }

std::string RawConnection::hear(int wait_ms) const {
  std::string heard;
  std::string bytes(65536, '\0');
  pollfd waiting{descriptor_, POLLIN, 0};
  while (::poll(&waiting, 1, wait_ms) > 0) {
    const ssize_t count = ::recv(descriptor_, bytes.data(), bytes.size(), 0);
    if (count <= 0) break;
    heard.append(bytes, 0, static_cast<std::size_t>(count));
  }
  heard_bytes().append(heard);
  return heard;
}

bool RawConnection::is_cut_off(int wait_ms) const {
  std::string bytes(65536, '\0');
  pollfd waiting{descriptor_, POLLIN, 0};
  while (::poll(&waiting, 1, wait_ms) > 0) {
    const ssize_t count = ::recv(descriptor_, bytes.data(), bytes.size(), 0);
    if (count <= 0) return true;
    heard_bytes().append(bytes, 0, static_cast<std::size_t>(count));
  }
  return false;
}

void RawConnection::close() {
  if (descriptor_ >= 0) ::close(std::exchange(descriptor_, -1));
}

int port_of(const std::string& address) {
  return std::stoi(address.substr(address.rfind(':') + 1));
}

std::string recorded_conversation(const std::string& endpoint,
                                  const std::function<void(const std::string&)>& converse) {
  const int listener = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  sockaddr_in address = loopback(0);
  EXPECT_EQ(::bind(listener, reinterpret_cast<sockaddr*>(&address), sizeof address), 0);
  EXPECT_EQ(::listen(listener, 1), 0);
  socklen_t size = sizeof address;
  ::getsockname(listener, reinterpret_cast<sockaddr*>(&address), &size);
  std::string said;
  std::thread between([&] {
    pollfd waiting{listener, POLLIN, 0};
    if (::poll(&waiting, 1, patience_ms) <= 0) return;
    said = pass_on(::accept(listener, nullptr, nullptr), connected(port_of(endpoint)));
  });
  converse("tcp://127.0.0.1:" + std::to_string(::ntohs(address.sin_port)));
  between.join();
  ::close(listener);
  return said;
}

}  // namespace tetfarm::test
