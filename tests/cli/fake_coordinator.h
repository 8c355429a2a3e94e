// A coordinator that answers as a test wants, in a thread and at an address of its own.
#pragma once

#include <atomic>
#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <utility>
#include <vector>
#include <zmq.hpp>

#include "proto/wire.h"
#include "tests/base/temp_folder.h"

namespace tetfarm {

class FakeCoordinator {
 public:
  /// What it answers to a message, in the thread of the coordinator; nothing: it is silent.
  using Answer = std::function<std::vector<wire::Envelope>(const wire::Envelope&)>;

  explicit FakeCoordinator(Answer answer) : answer_(std::move(answer)) {
    router_.set(zmq::sockopt::linger, 0);
    router_.set(zmq::sockopt::rcvtimeo, 5);
    router_.bind(endpoint());
    thread_ = std::thread([this] { serve(); });
  }
  ~FakeCoordinator() {
    is_over_ = true;
    thread_.join();
  }
  FakeCoordinator(const FakeCoordinator&) = delete;
  FakeCoordinator& operator=(const FakeCoordinator&) = delete;

  std::string endpoint() const { return "ipc://" + (folder_.path() / "socket").string(); }

  /// All that was said to it.
  std::vector<wire::Envelope> heard() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return heard_;
  }

 private:
  void serve() {
    while (!is_over_) {
      zmq::message_t peer;
      zmq::message_t message;
      if (!router_.recv(peer)) continue;
      if (!router_.recv(message)) continue;
      const Decoded decoded = decode(message.to_string_view());
      {
        const std::lock_guard<std::mutex> lock(mutex_);
        heard_.push_back(decoded.envelope);
      }
      for (const wire::Envelope& answer : answer_(decoded.envelope)) {
        const std::string bytes = encode(answer);
        router_.send(zmq::buffer(peer.data(), peer.size()), zmq::send_flags::sndmore);
        router_.send(zmq::buffer(bytes), zmq::send_flags::none);
      }
    }
  }

  TempFolder folder_;
  Answer answer_;
  zmq::context_t context_{1};
  zmq::socket_t router_{context_, zmq::socket_type::router};
  mutable std::mutex mutex_;
  std::vector<wire::Envelope> heard_;
  std::atomic<bool> is_over_ = false;
  std::thread thread_;
};

/// The answer to a question about the status: these jobs.
inline wire::Envelope reply_with(const std::vector<wire::JobStatus>& jobs) {
  wire::Envelope envelope;
  for (const wire::JobStatus& job : jobs) *envelope.mutable_status_reply()->add_jobs() = job;
  if (jobs.empty()) envelope.mutable_status_reply();
  return envelope;
}

}  // namespace tetfarm
