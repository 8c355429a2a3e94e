/// A wire between clients and a coordinator that a test can stop in the middle of a file.
#pragma once

#include <arpa/inet.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace tetfarm::test {

/// Listens on a port of its own at 127.0.0.1 and passes on what comes, both ways. What goes to the
/// clients, or what goes to the coordinator, stops after so many bytes until it is let through.
class TcpRelay {
 public:
  explicit TcpRelay(const std::string& endpoint)
      : target_(std::stoi(endpoint.substr(endpoint.rfind(':') + 1))),
        listener_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
    sockaddr_in address = loopback(0);
    socklen_t length = sizeof address;
    if (::bind(listener_, as_sockaddr(address), length) != 0 || ::listen(listener_, 64) != 0 ||
        ::getsockname(listener_, as_sockaddr(address), &length) != 0) {
      throw std::runtime_error("no port for a relay");
    }
    port_ = ntohs(address.sin_port);
    thread_ = std::thread([this] { run(); });
  }
  ~TcpRelay() {
    is_over_ = true;
    thread_.join();
    ::close(listener_);
  }
  TcpRelay(const TcpRelay&) = delete;
  TcpRelay& operator=(const TcpRelay&) = delete;

  std::string endpoint() const { return "tcp://127.0.0.1:" + std::to_string(port_); }
  void stop_after(std::int64_t to_clients, std::int64_t to_coordinator = no_limit) {
    left_to_clients_ = to_clients;
    left_to_coordinator_ = to_coordinator;
  }
  void let_through() { stop_after(no_limit); }
  /// Ends every connection.
  void cut() { is_cut_ = true; }
  std::int64_t to_clients() const { return to_clients_; }
  std::int64_t to_coordinator() const { return to_coordinator_; }

 private:
  static constexpr std::int64_t no_limit = std::int64_t{1} << 60;
  struct Pair {
    int client = -1;
    int coordinator = -1;
    bool is_open = true;
  };

  static sockaddr_in loopback(int port) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    address.sin_port = htons(static_cast<std::uint16_t>(port));
    return address;
  }
  static sockaddr* as_sockaddr(sockaddr_in& address) {
    return reinterpret_cast<sockaddr*>(&address);
  }

  void take_client() {
    const int client = ::accept4(listener_, nullptr, nullptr, SOCK_CLOEXEC);
    if (client < 0) return;
    sockaddr_in address = loopback(target_);
    const int coordinator = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    if (::connect(coordinator, as_sockaddr(address), sizeof address) != 0) {
      ::close(client);
      ::close(coordinator);
      return;
    }
    pairs_.push_back({client, coordinator});
  }

  /// Whether the connection still stands.
  static bool pass(int from, int to, std::atomic<std::int64_t>& left,
                   std::atomic<std::int64_t>& passed) {
    if (left <= 0) return true;
    std::array<char, 16384> bytes{};
    const ssize_t got = ::recv(from, bytes.data(), bytes.size(), MSG_DONTWAIT);
    if (got < 0) return errno == EAGAIN || errno == EINTR;
    if (got == 0) return false;
    for (ssize_t sent = 0; sent < got;) {
      const ssize_t now =
          ::send(to, bytes.data() + sent, static_cast<std::size_t>(got - sent), MSG_NOSIGNAL);
      if (now <= 0) return false;
      sent += now;
    }
    left -= got;
    passed += got;
    return true;
  }

  void run() {
    while (!is_over_) {
      std::vector<pollfd> wanted = {{listener_, POLLIN, 0}};
      for (const Pair& pair : pairs_) {
        wanted.push_back({left_to_coordinator_ > 0 ? pair.client : -1, POLLIN, 0});
        wanted.push_back({left_to_clients_ > 0 ? pair.coordinator : -1, POLLIN, 0});
      }
      ::poll(wanted.data(), wanted.size(), 5);
      const bool cuts = is_cut_.exchange(false);
      for (Pair& pair : pairs_) {
        pair.is_open = !cuts &&
                       pass(pair.client, pair.coordinator, left_to_coordinator_, to_coordinator_) &&
                       pass(pair.coordinator, pair.client, left_to_clients_, to_clients_);
        if (pair.is_open) continue;
        ::close(pair.client);
        ::close(pair.coordinator);
      }
      std::erase_if(pairs_, [](const Pair& pair) { return !pair.is_open; });
      if ((wanted.front().revents & POLLIN) != 0) take_client();
    }
    for (const Pair& pair : pairs_) {
      ::close(pair.client);
      ::close(pair.coordinator);
    }
  }

  int target_;
  int listener_;
  int port_ = 0;
  std::vector<Pair> pairs_;
  std::atomic<bool> is_over_ = false;
  std::atomic<bool> is_cut_ = false;
  std::atomic<std::int64_t> left_to_clients_ = no_limit;
  std::atomic<std::int64_t> left_to_coordinator_ = no_limit;
  std::atomic<std::int64_t> to_clients_ = 0;
  std::atomic<std::int64_t> to_coordinator_ = 0;
  std::thread thread_;
};

}  // namespace tetfarm::test
