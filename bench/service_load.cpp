// Workers whose tasks take no time: each a connection of its own to a real coordinator, encrypted
// where a key is given, speaking as worker/client.cpp does. Prints what happened as one line of
// JSON. None asks for a task before all are registered: what is measured is so many workers.
//
// service_load ENDPOINT STORE --workers N [--threads N] [--key FILE] [--tasks N | --idle SECONDS]
//   --tasks  ends when so many results have been accepted, of all workers
//   --idle   says Hello and Heartbeat only
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>
#include <zmq.hpp>

#include "base/clock.h"
#include "base/error.h"
#include "base/ids.h"
#include "proto/peer_security.h"
#include "proto/wire.h"
#include "store/artifact_store.h"
#include "tasks/task_kind.h"

namespace {

using namespace tetfarm;

constexpr std::int64_t hello_again_ms = 100;

struct Options {
  std::string endpoint;
  std::filesystem::path store;
  std::string key;
  std::size_t workers = 64;
  std::size_t threads = 4;
  std::uint64_t tasks = 0;
  std::int64_t idle_ms = 0;
};

/// What all workers share.
struct Load {
  Options options;
  std::optional<PeerKeys> keys;
  wire::Artifact result;
  std::atomic<std::size_t> registered{0};
  std::atomic<std::uint64_t> accepted{0};
  std::atomic<std::uint64_t> stale{0};
  std::atomic<std::uint64_t> heartbeats{0};
  std::atomic<std::uint64_t> answers{0};
  std::atomic<std::int64_t> first_task_ms{0};
  std::atomic<std::int64_t> over_ms{0};
};

class Worker {
 public:
  Worker(Load& load, zmq::context_t& context)
      : load_(load), socket_(context, zmq::socket_type::dealer), nonce_(random_hex(16)) {
    socket_.set(zmq::sockopt::linger, 500);
    socket_.set(zmq::sockopt::immediate, 1);
    secure(socket_, load.keys);
    socket_.connect(load.options.endpoint);
  }

  zmq::pollitem_t poll_item() { return {socket_.handle(), 0, ZMQ_POLLIN, 0}; }

  void take_messages() {
    zmq::message_t message;
    while (socket_.recv(message, zmq::recv_flags::dontwait)) {
      const Decoded decoded = decode(message.to_string_view());
      if (decoded.state != WireState::good) throw Error(ExitCode::failed, "unreadable message");
      take(decoded.envelope);
    }
  }

  void keep_time(std::int64_t now_ms) {
    if (!registered_ && now_ms >= hello_ms_) say_hello(now_ms);
    if (!registered_) return;
    if (!said_ready_ && load_.registered == load_.options.workers) say_ready();
    if (now_ms < beat_ms_) return;
    beat_ms_ = now_ms + heartbeat_ms_;
    wire::Envelope envelope;
    envelope.mutable_heartbeat()->set_task(task_);
    envelope.mutable_heartbeat()->set_attempt(attempt_);
    send(envelope);
    ++load_.heartbeats;
  }

  void leave() {
    wire::Envelope envelope;
    envelope.mutable_goodbye();
    if (registered_) send(envelope);
  }

 private:
  void send(const wire::Envelope& envelope) {
    socket_.send(zmq::buffer(encode(envelope)), zmq::send_flags::dontwait);
  }

  /// What is said before the connection is there is lost; an encrypted one takes a while.
  void say_hello(std::int64_t now_ms) {
    hello_ms_ = now_ms + hello_again_ms;
    wire::Envelope envelope;
    wire::Hello& hello = *envelope.mutable_hello();
    hello.set_program_version("load");
    hello.set_host("load");
    hello.set_process(::getpid());
    hello.set_cores(1);
    hello.set_memory_bytes(std::uint64_t{1} << 30U);
    hello.set_own_memory(true);
    hello.set_nonce(nonce_);
    send(envelope);
  }

  void say_ready() {
    said_ready_ = true;
    if (load_.options.idle_ms > 0) return;
    wire::Envelope envelope;
    envelope.mutable_ready();
    send(envelope);
  }

  void take(const wire::Envelope& envelope) {
    if (envelope.has_welcome()) {
      if (registered_) return;
      registered_ = true;
      heartbeat_ms_ = envelope.welcome().heartbeat_ms();
      // As if they had come one by one.
      beat_ms_ = steady_ms() + static_cast<std::int64_t>(load_.registered++ % heartbeat_ms_);
    } else if (envelope.has_assign()) {
      do_task(envelope.assign());
    } else if (envelope.has_accepted()) {
      if (envelope.accepted().attempt() != attempt_) return;
      (envelope.accepted().taken() ? load_.accepted : load_.stale) += 1;
      task_ = attempt_ = 0;
    } else if (envelope.has_heartbeat()) {
      ++load_.answers;
    } else if (envelope.has_refused()) {
      throw Error(ExitCode::failed, "refused: " + envelope.refused().reason());
    }
  }

  void do_task(const wire::Assign& assign) {
    if (attempt_ != 0) return;
    if (task_kind_on_wire(assign.kind()) != TaskKind::mesh) {
      throw Error(ExitCode::failed, "not a task to be meshed");
    }
    std::int64_t nobody = 0;
    load_.first_task_ms.compare_exchange_strong(nobody, steady_ms());
    task_ = assign.task();
    attempt_ = assign.attempt();
    wire::Envelope envelope;
    wire::Done& done = *envelope.mutable_done();
    done.set_task(task_);
    done.set_attempt(attempt_);
    *done.add_outputs() = load_.result;
    (*done.mutable_numbers())["tets"] = 1e6;
    (*done.mutable_numbers())["interior_nodes"] = 166'666;
    (*done.mutable_numbers())["cpu_seconds"] = 1;
    done.set_seconds(1);
    done.set_peak_rss_bytes(std::uint64_t{50} << 20U);
    send(envelope);
    say_ready();
  }

  Load& load_;
  zmq::socket_t socket_;
  const std::string nonce_;
  bool registered_ = false;
  bool said_ready_ = false;
  std::int64_t heartbeat_ms_ = 1000;
  std::int64_t hello_ms_ = 0;
  std::int64_t beat_ms_ = 0;
  std::uint64_t task_ = 0;
  std::uint64_t attempt_ = 0;
};

bool is_over(const Load& load) {
  if (load.options.idle_ms > 0) return load.over_ms > 0 && steady_ms() >= load.over_ms;
  return load.accepted >= load.options.tasks;
}

/// Some of the workers, in one thread.
void work(Load& load, zmq::context_t& context, std::size_t count) {
  std::vector<std::unique_ptr<Worker>> workers;
  std::vector<zmq::pollitem_t> items;
  for (std::size_t i = 0; i < count; ++i) {
    workers.push_back(std::make_unique<Worker>(load, context));
    items.push_back(workers.back()->poll_item());
  }
  while (!is_over(load)) {
    zmq::poll(items, std::chrono::milliseconds(20));
    const std::int64_t now = steady_ms();
    for (std::size_t i = 0; i < count; ++i) {
      if ((items[i].revents & ZMQ_POLLIN) != 0) workers[i]->take_messages();
      workers[i]->keep_time(now);
    }
    if (load.options.idle_ms > 0 && load.over_ms == 0 && load.registered == load.options.workers) {
      load.heartbeats = 0;
      load.answers = 0;
      load.over_ms = now + load.options.idle_ms;
      std::puts("all are here");
      std::fflush(stdout);
    }
  }
  load.over_ms = steady_ms();
  for (const auto& worker : workers) worker->leave();
}

void run(Load& load) {
  load.keys = read_peer_keys({load.options.key, ""}, load.options.store);
  const StoredArtifact file =
      ArtifactStore::open_existing(load.options.store).publish("nothing but a result");
  load.result.set_name("mesh");
  load.result.set_hash(file.hash);
  load.result.set_size(file.size);
  zmq::context_t context(1);
  context.set(zmq::ctxopt::max_sockets, static_cast<int>(2 * load.options.workers + 64));
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < load.options.threads; ++i) {
    const std::size_t share = (load.options.workers + i) / load.options.threads;
    threads.emplace_back([&load, &context, share] {
      try {
        work(load, context, share);
      } catch (const std::exception& error) {
        std::fprintf(stderr, "service_load: %s\n", error.what());
        std::_Exit(1);
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
}

Options options_of(const std::vector<std::string>& words) {
  Options options;
  options.endpoint = words.at(0);
  options.store = words.at(1);
  for (std::size_t i = 2; i < words.size(); i += 2) {
    const std::string& value = words.at(i + 1);
    if (words[i] == "--workers") options.workers = std::stoul(value);
    if (words[i] == "--threads") options.threads = std::stoul(value);
    if (words[i] == "--tasks") options.tasks = std::stoul(value);
    if (words[i] == "--idle") options.idle_ms = 1000 * std::stol(value);
    if (words[i] == "--key") options.key = value;
  }
  return options;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    Load load{.options = options_of({argv + 1, argv + argc}), .keys = {}, .result = {}};
    run(load);
    const double seconds = static_cast<double>(load.over_ms - load.first_task_ms) / 1000;
    std::printf(
        "{\"workers\": %zu, \"accepted\": %llu, \"stale\": %llu, \"seconds\": %.3f, "
        "\"heartbeats\": %llu, \"answers\": %llu}\n",
        load.options.workers, static_cast<unsigned long long>(load.accepted),
        static_cast<unsigned long long>(load.stale), seconds,
        static_cast<unsigned long long>(load.heartbeats),
        static_cast<unsigned long long>(load.answers));
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "service_load: %s\n", error.what());
    return 1;
  }
}
