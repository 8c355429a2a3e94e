#include "worker/client.h"

#include <spdlog/spdlog.h>
#include <unistd.h>

#include <algorithm>
#include <optional>

#include "base/clock.h"
#include "base/ids.h"
#include "store/attempt_scratch.h"
#include "worker/child_task.h"
#include "worker/coordinator_socket.h"
#include "worker/drain_signals.h"
#include "worker/file_exchange.h"
#include "worker/machine.h"
#include "worker/store_probe.h"

namespace tetfarm {
namespace {

constexpr std::int64_t first_hello_again_ms = 20;
constexpr std::int64_t slowest_hello_again_ms = 5'000;
constexpr std::int64_t result_again_ms = 1'000;
constexpr std::int64_t room_again_ms = 1'000;
constexpr std::int64_t tick_ms = 100;
constexpr std::int64_t flag_tick_ms = 10;

class Client {
 public:
  explicit Client(const WorkerOptions& options)
      : options_(options),
        signals_(options.handle_signals),
        nonce_(random_hex(16)),
        memory_bytes_(options.memory_bytes > 0 ? options.memory_bytes : machine_memory()),
        ends_at_(options.ends_in_ms > 0 ? steady_ms() + options.ends_in_ms : 0),
        socket_(options.endpoint, options.keys, options.store),
        probe_(options.store),
        files_(options.cache, options.cache_bytes),
        host_(options.host_command) {}

  ExitCode run() {
    host_.prepare();
    connect();
    while (!finished_) {
      wait();
      take_signals();
      socket_.check_handshake();
      take_messages();
      take_outcome();
      move_files();
      keep_time();
    }
    return ExitCode::ok;
  }

 private:
  bool is_idle() const { return attempt_ == 0; }

  void connect() {
    socket_.connect();
    registered_ = false;
    say_hello();
  }

  /// Whatever does not arrive is said again later: the protocol does not rely on arrival.
  void send(const wire::Envelope& envelope) { socket_.send(envelope); }

  void say_hello() {
    hello_at_ = steady_ms() + hello_again_ms_;
    hello_again_ms_ = std::min(2 * hello_again_ms_, slowest_hello_again_ms);
    wire::Envelope envelope;
    wire::Hello& hello = *envelope.mutable_hello();
    if (!probe_.put_into(hello, steady_ms())) return;
    hello.set_program_version(program_version);
    hello.set_host(host_name());
    hello.set_process(::getpid());
    hello.set_cores(static_cast<std::uint32_t>(::sysconf(_SC_NPROCESSORS_ONLN)));
    hello.set_memory_bytes(memory_bytes_);
    hello.set_own_memory(options_.memory_bytes > 0);
    hello.set_nonce(nonce_);
    hello.set_tag(options_.tag);
    hello.set_pool_memory_bytes(options_.pool_memory_bytes);
    if (ends_at_ > 0) {
      hello.set_ends_in_ms(
          static_cast<std::uint64_t>(std::max<std::int64_t>(1, ends_at_ - steady_ms())));
    }
    hello.set_running_task(task_);
    hello.set_running_attempt(attempt_);
    hello_waits_for_connection_ = !socket_.send(envelope);
  }

  /// Who has no room for a task's files waits until there is some.
  void say_ready_or_leave() {
    wire::Envelope envelope;
    ready_at_ = 0;
    if (!draining_ && !sees_store_ && !files_.has_room()) {
      ready_at_ = steady_ms() + room_again_ms;
      return;
    }
    if (draining_) {
      envelope.mutable_goodbye();
      finished_ = true;
    } else {
      envelope.mutable_ready();
    }
    send(envelope);
  }

  /// With what it has left when it was killed.
  void end_child() {
    if (!child_) return;
    child_.reset();
    doing_.Clear();
    try {
      remove_attempt_scratch(ArtifactStore::open_existing(task_store_), AttemptId{attempt_});
    } catch (const IoError& error) {
      spdlog::warn("{}", error.what());
    }
  }

  void forget_task() {
    end_child();
    unaccepted_.reset();
    said_ready_ = false;
    result_waits_for_files_ = false;
    task_ = 0;
    attempt_ = 0;
    try {
      files_.forget_task();
    } catch (const IoError& error) {
      spdlog::warn("{}", error.what());
    }
  }

  void wait() {
    std::vector<zmq::pollitem_t> items = {socket_.poll_item(hello_waits_for_connection_)};
    if (signals_.fd() >= 0) items.push_back({nullptr, signals_.fd(), ZMQ_POLLIN, 0});
    if (child_) items.push_back({nullptr, child_->fd(), ZMQ_POLLIN, 0});
    try {
      zmq::poll(items,
                std::chrono::milliseconds(options_.drain != nullptr ? flag_tick_ms : tick_ms));
    } catch (const zmq::error_t& error) {
      if (error.num() != EINTR) throw;
      return;
    }
    if ((items[0].revents & ZMQ_POLLOUT) != 0) say_hello();
  }

  void take_signals() {
    if (signals_.take_one()) start_drain(draining_ ? 0 : options_.grace_ms);
    if (!draining_ && options_.drain != nullptr && options_.drain->load()) {
      start_drain(options_.grace_ms);
    }
    if (!draining_ && ends_at_ > 0 && steady_ms() >= ends_at_ - options_.grace_ms) {
      spdlog::info("this worker's time is nearly up");
      start_drain(options_.grace_ms);
    }
  }

  void start_drain(std::int64_t grace_ms) {
    spdlog::info("draining{}", is_idle() ? "" : ": a task is running");
    draining_ = true;
    drain_until_ = steady_ms() + grace_ms;
    if (is_idle()) say_ready_or_leave();
  }

  void take_messages() {
    while (!finished_) {
      const std::optional<wire::Envelope> envelope = socket_.receive();
      if (!envelope) return;
      heard_at_ = steady_ms();
      take(*envelope);
    }
  }

  void take(const wire::Envelope& envelope) {
    switch (envelope.body_case()) {
      case wire::Envelope::kWelcome:
        return take_welcome(envelope.welcome());
      case wire::Envelope::kRefused:
        return take_refused(envelope.refused());
      case wire::Envelope::kAssign:
        return take_assign(envelope.assign());
      case wire::Envelope::kAccepted:
        return take_accepted(envelope.accepted());
      case wire::Envelope::kFileChunk:
      case wire::Envelope::kFileStored:
        return with_files([&] { files_.take(envelope, heard_at_); });
      case wire::Envelope::kDrain:
        return start_drain(options_.grace_ms);
      default:
        return;
    }
  }

  void take_welcome(const wire::Welcome& welcome) {
    // A coordinator that started meanwhile has swept it away.
    if (!welcome.sees_store() && probe_.is_lost()) return say_hello();
    registered_ = true;
    note_store(welcome.sees_store());
    hello_again_ms_ = first_hello_again_ms;
    heartbeat_ms_ = std::max<std::int64_t>(welcome.heartbeat_ms(), 10);
    lease_ms_ = std::max<std::int64_t>(welcome.lease_ms(), 2 * heartbeat_ms_);
    if (!is_idle() && !welcome.keep_running()) {
      spdlog::info("task {} attempt {} is no longer wanted", task_, attempt_);
      forget_task();
    }
    files_.ask_again();
    if (unaccepted_) send_result();
    if (is_idle()) say_ready_or_leave();
  }

  /// Counts from the next task on.
  void note_store(bool sees_store) {
    if (sees_store_ && !sees_store) {
      spdlog::info("files are transferred over the connection and kept in {}",
                   options_.cache.string());
    }
    sees_store_ = sees_store;
  }

  void take_refused(const wire::Refused& refused) {
    if (!refused.hello_again()) {
      throw Error(ExitCode::failed, "the coordinator refused this worker: " + refused.reason());
    }
    registered_ = false;
    say_hello();
  }

  void take_assign(const wire::Assign& assign) {
    if (!is_idle() || draining_) return;
    ready_at_ = 0;
    task_ = assign.task();
    attempt_ = assign.attempt();
    spdlog::info("{} task {} attempt {}: {} {}", assign.job(), task_, attempt_,
                 wire::TaskKind_Name(assign.kind()), assign.path());
    assign_ = assign;
    is_apart_ = !sees_store_;
    assign_.set_apart(is_apart_);
    if (!is_apart_) return start_child(options_.store);
    with_files([&] { files_.fetch_inputs(assign_); });
    if (child_ || unaccepted_ || files_.is_fetching()) return;
    start_child_apart();
  }

  void start_child_apart() {
    with_files([&] { start_child(files_.store().folder()); });
  }

  void start_child(const std::filesystem::path& store) {
    const ChildTaskOptions child{.command = options_.task_command,
                                 .store = store.string(),
                                 .host = &host_,
                                 .memory_limit_bytes = memory_bytes_};
    limit_ms_ = static_cast<std::int64_t>(assign_.limit_ms());
    assigned_at_ = steady_ms();
    task_store_ = store;
    try {
      child_.emplace(child, assign_);
    } catch (const IoError& error) {
      fail(error);
    }
  }

  /// The attempt ends here because of the world around it. An output that was lost is no fault of
  /// the task: it is counted leniently.
  void fail(const Error& error, const std::string& damaged_input = "",
            bool output_is_lost = false) {
    end_child();
    unaccepted_.emplace();
    wire::Failed& failed = *unaccepted_->mutable_failed();
    failed.set_task(task_);
    failed.set_attempt(attempt_);
    failed.set_message(error.what());
    failed.set_exit_code(static_cast<int>(error.code()));
    failed.set_may_retry(true);
    failed.set_out_of_resources(error.code() == ExitCode::out_of_resources);
    failed.set_killed(output_is_lost);
    if (!damaged_input.empty()) failed.add_damaged_inputs(damaged_input);
    blame_own_disk(failed);
    files_.forget_task();
    send_result();
  }

  /// A full disk of this worker alone must not stop the others: the task goes elsewhere.
  void blame_own_disk(wire::Failed& failed) const {
    if (!is_apart_ || !failed.out_of_resources()) return;
    failed.set_out_of_resources(false);
    failed.set_killed(true);
  }

  template <class Action>
  void with_files(const Action& action) {
    try {
      action();
    } catch (const CorruptFile& error) {
      fail(error, "", true);
    } catch (const IoError& error) {
      fail(error);
    }
  }

  /// Inputs that come, outputs that go; the task starts, and its result is told, when they are
  /// there.
  void move_files() {
    if (!is_apart_ || is_idle() || !registered_) return;
    if (!files_.damaged_input().empty()) {
      const std::string hash = files_.damaged_input();
      return fail(Error(ExitCode::failed, "the coordinator has no intact copy of file " + hash),
                  hash);
    }
    with_files([&] {
      for (const wire::Envelope& message : files_.due(steady_ms())) send(message);
    });
    if (!child_ && !unaccepted_ && !files_.is_fetching()) start_child_apart();
    if (result_waits_for_files_ && !files_.is_sending()) send_result();
  }

  void take_accepted(const wire::Accepted& accepted) {
    if (accepted.attempt() != attempt_ || accepted.task() != task_ || is_idle()) return;
    if (child_ && accepted.taken()) return;
    if (!accepted.taken()) spdlog::info("task {} attempt {} is stale", task_, attempt_);
    const bool waits_for_next = said_ready_ && !draining_;
    forget_task();
    if (!waits_for_next) return say_ready_or_leave();
    // Should that Ready have been lost, it is said again.
    ready_at_ = steady_ms() + heartbeat_ms_;
  }

  void take_outcome() {
    if (!child_) return;
    std::optional<wire::Envelope> outcome =
        child_->poll([this](const wire::Doing& doing) { doing_ = doing; });
    if (!outcome) return;
    end_child();
    unaccepted_ = std::move(outcome);
    if (is_apart_) with_files([&] { files_.send_outputs(*unaccepted_); });
    if (unaccepted_->has_failed()) {
      blame_own_disk(*unaccepted_->mutable_failed());
      spdlog::warn("task {} attempt {}: {}", task_, attempt_, unaccepted_->failed().message());
    }
    send_result();
  }

  void send_result() {
    result_waits_for_files_ = files_.is_sending();
    if (result_waits_for_files_) return;
    result_at_ = steady_ms() + result_again_ms;
    if (!registered_) return;
    send(*unaccepted_);
    said_ready_ = unaccepted_->has_done() && sees_store_ && !draining_;
    if (!said_ready_) return;
    // The next task then comes with the answer, out of the same transaction.
    wire::Envelope envelope;
    envelope.mutable_ready();
    send(envelope);
  }

  void keep_time() {
    const std::int64_t now = steady_ms();
    if (finished_) return;
    if (draining_ && now >= drain_until_) {
      spdlog::info("handing back task {} attempt {}", task_, attempt_);
      forget_task();
      return say_ready_or_leave();
    }
    if (child_ && limit_ms_ > 0 && now - assigned_at_ > limit_ms_) child_->end_overdue(limit_ms_);
    if (!registered_) {
      if (now >= hello_at_) say_hello();
      return;
    }
    if (now - heard_at_ > lease_ms_) {
      spdlog::warn("the coordinator is silent; reconnecting");
      return connect();
    }
    if (ready_at_ > 0 && now >= ready_at_ && is_idle()) say_ready_or_leave();
    if (now >= heartbeat_at_) {
      heartbeat_at_ = now + heartbeat_ms_;
      wire::Envelope envelope;
      envelope.mutable_heartbeat()->set_task(task_);
      envelope.mutable_heartbeat()->set_attempt(attempt_);
      if (child_ && !doing_.stage().empty())
        *envelope.mutable_heartbeat()->mutable_doing() = doing_;
      send(envelope);
    }
    if (unaccepted_ && now >= result_at_) send_result();
  }

  static constexpr const char* program_version = "0.1.0";

  const WorkerOptions& options_;
  DrainSignals signals_;
  const std::string nonce_;
  const std::uint64_t memory_bytes_;
  const std::int64_t ends_at_;  ///< 0: not known
  CoordinatorSocket socket_;

  StoreProbe probe_;
  FileExchange files_;
  bool sees_store_ = true;
  bool is_apart_ = false;  ///< of the task at hand: it runs in the worker's own store
  wire::Assign assign_;

  bool registered_ = false;
  bool draining_ = false;
  bool finished_ = false;
  std::uint64_t task_ = 0;
  std::uint64_t attempt_ = 0;
  TaskHost host_;
  std::optional<ChildTask> child_;
  wire::Doing doing_;                 ///< what its task said last
  std::filesystem::path task_store_;  ///< where the task at hand runs
  std::optional<wire::Envelope> unaccepted_;

  std::int64_t hello_again_ms_ = first_hello_again_ms;
  std::int64_t hello_at_ = 0;
  bool hello_waits_for_connection_ = false;
  std::int64_t heard_at_ = 0;
  std::int64_t heartbeat_ms_ = 1'000;
  std::int64_t lease_ms_ = 10'000;
  std::int64_t heartbeat_at_ = 0;
  std::int64_t result_at_ = 0;
  bool result_waits_for_files_ = false;
  bool said_ready_ = false;    ///< with the result that is not accepted yet
  std::int64_t ready_at_ = 0;  ///< when to say that again, or to look for room; 0: not at all
  std::int64_t drain_until_ = 0;
  std::int64_t limit_ms_ = 0;
  std::int64_t assigned_at_ = 0;
};

}  // namespace

ExitCode run_worker(const WorkerOptions& options) { return Client(options).run(); }

}  // namespace tetfarm
