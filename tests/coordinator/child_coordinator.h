// A real coordinator in a process of its own, and hand-written peers.
#pragma once

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <thread>
#include <zmq.hpp>

#include "coordinator/server.h"
#include "proto/peer_security.h"
#include "proto/wire.h"

namespace tetfarm::test {

constexpr int repeat_ms = 500;
constexpr int patience_ms = 20000;

/// A coordinator in a process of its own, so that it can be killed.
class ChildCoordinator {
 public:
  /// Listens in the store's folder unless told where.
  explicit ChildCoordinator(const std::filesystem::path& store, CoordinatorOptions options = {})
      : store_(store) {
    options.store = store;
    if (options.endpoints.empty()) options.endpoints = {"ipc://" + (store / "socket").string()};
    options.heartbeat_ms = 50;
    options.lease_ms = 60000;
    std::filesystem::remove(endpoints_file(store));  // of one that was killed
    process_ = fork();
    if (process_ != 0) {
      wait_until_it_listens();
      return;
    }
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);  // a test that is stopped leaves no coordinator behind
    try {
      run_coordinator(options);
    } catch (const std::exception& error) {
      fprintf(stderr, "%s\n", error.what());
      _exit(1);
    }
    _exit(0);
  }
  ~ChildCoordinator() { stop(SIGKILL); }

  int stop(int signal_number) {
    if (process_ == 0) return 0;
    kill(process_, signal_number);
    int status = 0;
    waitpid(process_, &status, 0);
    process_ = 0;
    return status;
  }
  /// The coordinator's files may not grow beyond this: what a full disk or quota looks like to it.
  void limit_file_size(rlim_t bytes) const {
    const rlimit limit{bytes, RLIM_INFINITY};
    EXPECT_EQ(prlimit(process_, RLIMIT_FSIZE, &limit, nullptr), 0);
  }
  const std::string& endpoint() const { return endpoint_; }

 private:
  void wait_until_it_listens() {
    for (int waited = 0; waited < patience_ms && endpoint_.empty(); waited += 5) {
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
      std::ifstream file(endpoints_file(store_));
      std::getline(file, endpoint_);
    }
    EXPECT_FALSE(endpoint_.empty()) << "the coordinator does not listen";
  }

  std::filesystem::path store_;
  std::string endpoint_;
  pid_t process_ = 0;
};

/// A hand-written worker or client.
class Dealer {
 public:
  /// `routing_id` "": one that ZeroMQ makes up.
  explicit Dealer(const std::string& endpoint, const std::optional<PeerKeys>& keys = std::nullopt,
                  const std::string& routing_id = "")
      : socket_(context_, zmq::socket_type::dealer) {
    if (!routing_id.empty()) socket_.set(zmq::sockopt::routing_id, routing_id);
    secure(socket_, keys);
    socket_.set(zmq::sockopt::linger, 0);
    socket_.set(zmq::sockopt::rcvtimeo, patience_ms);
    socket_.set(zmq::sockopt::reconnect_ivl, 10);
    socket_.connect(endpoint);
  }
  void send_bytes(const std::string& bytes) { socket_.send(zmq::buffer(bytes)); }
  void send(const wire::Envelope& envelope) { send_bytes(encode(envelope)); }

  /// The next message that is no heartbeat.
  wire::Envelope receive() {
    for (;;) {
      zmq::message_t message;
      if (!socket_.recv(message)) {
        ADD_FAILURE() << "no answer";
        return {};
      }
      Decoded decoded = decode(message.to_string_view());
      EXPECT_EQ(decoded.state, WireState::good);
      if (!decoded.envelope.has_heartbeat()) return decoded.envelope;
    }
  }
  /// Whether nothing comes within that time.
  bool hears_nothing(int wait_ms) {
    zmq::pollitem_t item{socket_.handle(), 0, ZMQ_POLLIN, 0};
    return zmq::poll(&item, 1, std::chrono::milliseconds(wait_ms)) == 0;
  }
  wire::Envelope ask(const wire::Envelope& envelope) {
    send(envelope);
    return receive();
  }
  /// For a coordinator that cannot commit: what it was asked in that turn it never answers.
  wire::Envelope ask_until_answered(const wire::Envelope& envelope) {
    for (int i = 0; i < patience_ms / repeat_ms; ++i) {
      send(envelope);
      zmq::pollitem_t item{socket_.handle(), 0, ZMQ_POLLIN, 0};
      if (zmq::poll(&item, 1, std::chrono::milliseconds(repeat_ms)) > 0) return receive();
    }
    ADD_FAILURE() << "no answer";
    return {};
  }

 private:
  zmq::context_t context_;
  zmq::socket_t socket_;
};

}  // namespace tetfarm::test
