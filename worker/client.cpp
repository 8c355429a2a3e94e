#include "worker/client.h"

#include <spdlog/spdlog.h>
#include <unistd.h>

#include <algorithm>
#include <optional>
#include <variant>

#include "base/clock.h"
#include "base/ids.h"
#include "base/program_version.h"
#include "store/attempt_scratch.h"
#include "worker/child_task.h"
#include "worker/coordinator_socket.h"
#include "worker/decisions/worker_state.h"
#include "worker/drain_signals.h"
#include "worker/file_exchange.h"
#include "worker/machine.h"
#include "worker/store_probe.h"

namespace tetfarm {
namespace {

constexpr std::size_t nonce_bytes = 16;
constexpr std::int64_t longest_wait_ms = 100;
constexpr std::int64_t flag_wait_ms = 10;

std::uint64_t memory_of(const WorkerOptions& options) {
  return options.memory_bytes > 0 ? options.memory_bytes : machine_memory();
}

wire::Hello self_of(const WorkerOptions& options) {
  wire::Hello hello;
  hello.set_program_version(program_version);
  hello.set_host(host_name());
  hello.set_process(::getpid());
  hello.set_cores(static_cast<std::uint32_t>(::sysconf(_SC_NPROCESSORS_ONLN)));
  hello.set_memory_bytes(memory_of(options));
  hello.set_own_memory(options.memory_bytes > 0);
  hello.set_nonce(random_hex(nonce_bytes));
  hello.set_tag(options.tag);
  hello.set_pool_memory_bytes(options.pool_memory_bytes);
  hello.set_runs_solvers(options.runs_solvers);
  return hello;
}

WorkerTerms terms_of(const WorkerOptions& options, std::int64_t now_ms) {
  return {.ends_ms = options.ends_in_ms > 0 ? now_ms + options.ends_in_ms : 0,
          .grace_ms = options.grace_ms,
          .cache = options.cache.string()};
}

/// Carries out what WorkerState decides, and tells it what happens. The clock is read once a turn.
class Client {
 public:
  explicit Client(const WorkerOptions& options)
      : options_(options),
        signals_(options.handle_signals),
        socket_(options.endpoint, options.keys, options.store),
        probe_(options.store),
        files_(options.cache, options.cache_bytes),
        host_(options.host_command),
        now_ms_(steady_ms()),
        state_(self_of(options), terms_of(options, now_ms_), now_ms_) {}

  ExitCode run() {
    host_.prepare();
    carry_out_all();
    while (state_.phase() != WorkerPhase::gone) {
      wait();
      take_signals();
      socket_.check_handshake();
      take_messages();
      take_outcome();
      move_files();
      state_.tick(now_ms_);
      carry_out_all();
    }
    return ExitCode::ok;
  }

 private:
  // ---- what happens

  void wait() {
    const bool waits_for_connection = state_.link() == WorkerLink::unreachable;
    std::vector<zmq::pollitem_t> items = {socket_.poll_item(waits_for_connection)};
    if (signals_.fd() >= 0) items.push_back({nullptr, signals_.fd(), ZMQ_POLLIN, 0});
    if (child_) items.push_back({nullptr, child_->fd(), ZMQ_POLLIN, 0});
    const std::int64_t longest_ms = options_.drain != nullptr ? flag_wait_ms : longest_wait_ms;
    const std::int64_t wait_ms = std::clamp<std::int64_t>(state_.due_ms() - now_ms_, 0, longest_ms);
    try {
      zmq::poll(items, std::chrono::milliseconds(wait_ms));
    } catch (const zmq::error_t& error) {
      if (error.num() != EINTR) throw;
    }
    now_ms_ = steady_ms();
    if ((items[0].revents & ZMQ_POLLOUT) != 0) state_.connection_is_there(now_ms_);
    carry_out_all();
  }

  void take_signals() {
    if (signals_.take_one()) state_.signal_came(now_ms_);
    if (options_.drain != nullptr && options_.drain->load()) state_.drain(now_ms_);
    carry_out_all();
  }

  void take_messages() {
    while (state_.phase() != WorkerPhase::gone) {
      const std::optional<wire::Envelope> message = socket_.receive();
      if (!message) return;
      if (has_lost_probe(*message)) {
        state_.probe_was_swept_away(now_ms_);
      } else {
        state_.hear(*message, now_ms_);
      }
      carry_out_all();
      if (message->has_file_chunk() || message->has_file_stored()) {
        with_files([&] { files_.take(*message, now_ms_); });
      }
    }
  }

  /// A coordinator that started meanwhile has swept it away.
  bool has_lost_probe(const wire::Envelope& message) const {
    return message.has_welcome() && !message.welcome().sees_store() && probe_.is_lost();
  }

  void take_outcome() {
    if (!child_) return;
    std::optional<wire::Envelope> outcome =
        child_->poll([this](const wire::Doing& doing) { state_.child_does(doing); });
    if (!outcome) return;
    end_child();
    state_.child_ended(std::move(*outcome), now_ms_);
    carry_out_all();
  }

  /// Inputs that come, outputs that go.
  void move_files() {
    if (!state_.may_move_files()) return;
    with_files([&] {
      for (const wire::Envelope& message : files_.due(now_ms_)) socket_.send(message);
    });
    tell_files();
    carry_out_all();
  }

  void tell_files() {
    if (!files_.damaged_input().empty()) {
      state_.input_is_damaged(files_.damaged_input(), now_ms_);
    } else if (state_.phase() == WorkerPhase::fetching && !files_.is_fetching()) {
      state_.inputs_came(now_ms_);
    } else if (state_.phase() == WorkerPhase::uploading && !files_.is_sending()) {
      state_.outputs_went(now_ms_);
    }
  }

  template <class Action>
  void with_files(const Action& action) {
    try {
      action();
    } catch (const CorruptFile& error) {
      state_.files_failed(error, true, now_ms_);
    } catch (const IoError& error) {
      state_.files_failed(error, false, now_ms_);
    }
  }

  // ---- what is to be done

  /// What is done may bring more to do.
  void carry_out_all() {
    for (auto commands = state_.take_commands(); !commands.empty();
         commands = state_.take_commands()) {
      for (const WorkerCommand& command : commands) {
        std::visit([this](const auto& one) { carry_out(one); }, command);
      }
    }
  }

  void carry_out(const ConnectAnew&) { socket_.connect(); }

  void carry_out(const SayHello& command) {
    wire::Envelope envelope;
    *envelope.mutable_hello() = command.hello;
    if (!probe_.put_into(*envelope.mutable_hello(), now_ms_)) return;
    if (!socket_.send(envelope)) state_.hello_was_not_sent();
  }

  void carry_out(const SendMessage& command) { socket_.send(command.envelope); }

  void carry_out(const LookForRoom&) { state_.room_was_looked_for(files_.has_room(), now_ms_); }

  void carry_out(const FetchInputs& command) {
    with_files([&] {
      files_.fetch_inputs(command.assign);
      tell_files();
    });
  }

  void carry_out(const StartChild& command) {
    try {
      task_store_ = command.is_without_shared_store ? files_.store().folder() : options_.store;
      const ChildTaskOptions child{.command = options_.task_command,
                                   .store = task_store_.string(),
                                   .is_without_shared_store = command.is_without_shared_store,
                                   .host = &host_,
                                   .memory_limit_bytes = memory_of(options_)};
      child_.emplace(child, command.assign);
    } catch (const IoError& error) {
      state_.child_did_not_start(error, now_ms_);
    }
  }

  void carry_out(const EndOverdueChild& command) {
    if (child_) child_->end_overdue(command.limit_ms);
  }

  void carry_out(const EndChild&) { end_child(); }

  void carry_out(const UploadOutputs& command) {
    with_files([&] {
      files_.send_outputs(command.outcome);
      tell_files();
    });
  }

  void carry_out(const AskForFilesAgain&) { files_.ask_again(); }

  void carry_out(const ForgetFiles&) {
    try {
      files_.forget_task();
    } catch (const IoError& error) {
      spdlog::warn("{}", error.what());
    }
  }

  void carry_out(const TellLog& command) {
    spdlog::log(command.is_warning ? spdlog::level::warn : spdlog::level::info, "{}", command.text);
  }

  void carry_out(const ExitWorker& command) {
    if (!command.is_refused) return;
    throw Error(ExitCode::failed, "the coordinator refused this worker: " + command.reason);
  }

  /// With what it has left when it was killed.
  void end_child() {
    if (!child_) return;
    const AttemptId attempt{child_->attempt()};
    child_.reset();
    try {
      remove_attempt_scratch(ArtifactStore::open_existing(task_store_), attempt);
    } catch (const IoError& error) {
      spdlog::warn("{}", error.what());
    }
  }

  const WorkerOptions& options_;
  DrainSignals signals_;
  CoordinatorSocket socket_;
  StoreProbe probe_;
  FileExchange files_;
  TaskHost host_;
  std::optional<ChildTask> child_;
  std::filesystem::path task_store_;  ///< where it runs
  std::int64_t now_ms_;
  WorkerState state_;
};

}  // namespace

ExitCode run_worker(const WorkerOptions& options) { return Client(options).run(); }

}  // namespace tetfarm
