// A worker process as proto/protocol.md and worker/client.cpp describe it, without sockets, and the
// child that does its task.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tests/coordinator/fake_task.h"
#include "tests/coordinator/simulated_world.h"

namespace tetfarm::simulation {

constexpr std::int64_t beat_ms = 250;
constexpr std::int64_t worker_lease_ms = 1000;
constexpr std::int64_t grace_ms = 400;
constexpr std::int64_t sync_ms = 5;
constexpr std::int64_t never_ms = std::int64_t{1} << 60U;

/// What a worker sees of the world.
struct Surroundings {
  Random& random;
  const Trouble& trouble;
  Disk& disk;
  const std::map<TaskId, TaskRow>& tasks;        // as committed
  const std::map<AttemptId, AttemptRow>& rooms;  // of running attempts, as committed
  std::function<bool(const TaskRow&)> is_hopeless;
  std::function<bool(const TaskRow&)> is_giant;
  std::string bad_host;
  std::int64_t now_ms = 0;
  std::function<void(int, ToCoordinator)> post;
  std::function<int()> new_connection;
};

/// What a task takes: the same at each try.
inline std::uint64_t room_of(const TaskRow& task) {
  const std::uint64_t lot =
      hash128(std::string(name_of(task.kind)) + std::to_string(task.path)).low;
  return (lot % 9 == 0 ? 700 : 100 + lot % 100) << 20U;
}

class Worker {
 public:
  Worker(WorkerInfo info, Surroundings& world) : info_(std::move(info)), heard_ms_(world.now_ms) {
    ends_ms_ = info_.ends_in_ms > 0 ? world.now_ms + info_.ends_in_ms : 0;
    connect(world);
  }

  int connection() const { return connection_; }
  const std::string& host() const { return info_.host; }
  const std::string& nonce() const { return info_.nonce; }
  TaskId task() const { return task_; }
  AttemptId attempt() const { return attempt_; }
  bool is_gone() const { return is_gone_; }
  bool is_stopped(std::int64_t now_ms) const { return now_ms < stopped_until_ms_; }
  void stop(std::int64_t until_ms) { stopped_until_ms_ = until_ms; }
  /// The socket connects anew under the program: the coordinator sees somebody it does not know.
  void change_connection(int connection) { connection_ = connection; }
  /// When it has something to do of itself.
  std::int64_t wakes_ms() const { return std::max(stopped_until_ms_, wakes_ms_); }

  void start_drain(Surroundings& world) {
    if (is_draining_) return;
    is_draining_ = true;
    drain_until_ms_ = world.now_ms + grace_ms;
    wakes_ms_ = world.now_ms;
    if (!attempt_) say_ready_or_leave(world);
  }

  void hear(const ToWorker& message, Surroundings& world) {
    if (is_stopped(world.now_ms)) {
      waiting_.push_back(message);
    } else {
      obey(message, world);
    }
  }

  void live(Surroundings& world) {
    if (world.now_ms < wakes_ms()) return;
    for (const ToWorker& message : std::exchange(waiting_, {})) obey(message, world);
    if (is_gone_) return;
    if (ends_ms_ > 0 && world.now_ms >= ends_ms_ - grace_ms) start_drain(world);
    if (attempt_ && !unaccepted_ && world.now_ms >= finishes_ms_) finish(world);
    if (attempt_ && !unaccepted_ && world.now_ms > overdue_ms_) fail_overdue(world);
    if (is_draining_ && attempt_ && world.now_ms >= drain_until_ms_) {
      forget();
      say_ready_or_leave(world);
    }
    if (!is_gone_) keep_time(world);
    wakes_ms_ = next_ms(world.now_ms);
  }

 private:
  void connect(Surroundings& world) {
    connection_ = world.new_connection();
    is_registered_ = false;
    say_hello(world);
  }

  void say_hello(Surroundings& world) {
    hello_ms_ = world.now_ms + 200;
    info_.ends_in_ms = ends_ms_ > 0 ? std::max<std::int64_t>(1, ends_ms_ - world.now_ms) : 0;
    world.post(connection_, Hello{info_, task_, attempt_});
  }

  void say_ready_or_leave(Surroundings& world) {
    if (is_draining_) {
      is_gone_ = true;
      world.post(connection_, Bye{});
    } else {
      world.post(connection_, Ready{});
    }
  }

  /// Who has done its task asks for the next one with the result.
  void say_result(Surroundings& world) {
    world.post(connection_, *unaccepted_);
    said_ready_ = std::holds_alternative<DoneSaid>(*unaccepted_) && !is_draining_;
    if (said_ready_) world.post(connection_, Ready{});
  }

  void forget() {
    said_ready_ = false;
    task_ = {};
    attempt_ = {};
    unaccepted_.reset();
    written_.clear();
    finishes_ms_ = never_ms;
    overdue_ms_ = never_ms;
  }

  void keep_time(Surroundings& world) {
    if (!is_registered_) {
      if (world.now_ms >= hello_ms_) say_hello(world);
      return;
    }
    if (world.now_ms > heard_ms_ + worker_lease_ms) {
      heard_ms_ = world.now_ms;
      return connect(world);
    }
    if (world.now_ms < beat_at_ms_) return;
    beat_at_ms_ = world.now_ms + beat_ms;
    world.post(connection_, Beat{task_, attempt_});
    if (unaccepted_) say_result(world);
    // A real one says it once: what ZeroMQ loses it loses with the connection.
    if (!attempt_) world.post(connection_, Ready{});
  }

  std::int64_t next_ms(std::int64_t now_ms) const {
    std::int64_t next =
        is_registered_ ? std::min(beat_at_ms_, heard_ms_ + worker_lease_ms + 1) : hello_ms_;
    if (attempt_ && !unaccepted_) next = std::min({next, finishes_ms_, overdue_ms_ + 1});
    if (attempt_ && is_draining_) next = std::min(next, drain_until_ms_);
    if (ends_ms_ > 0 && !is_draining_) next = std::min(next, ends_ms_ - grace_ms);
    return std::max(next, now_ms + 1);
  }

  // ---- the child
  void start(const SendAssign& assign, Surroundings& world) {
    task_ = assign.task;
    attempt_ = assign.attempt;
    started_ms_ = world.now_ms;
    overdue_ms_ = world.now_ms + assign.limit_ms;
    const bool hangs = world.random.chance(world.trouble.hang);
    const std::int64_t slowest = world.random.chance(0.1) ? 3000 : 300;
    finishes_ms_ = hangs ? never_ms : world.now_ms + 10 + world.random.pick(slowest);
  }

  void fail(TaskFailure failure, Surroundings& world) {
    failure.message = "make-believe";
    unaccepted_ = FailedSaid{task_, attempt_, std::move(failure)};
    world.post(connection_, *unaccepted_);
  }

  void fail_overdue(Surroundings& world) {
    TaskFailure failure;
    failure.may_retry = true;
    fail(std::move(failure), world);
  }

  /// The failure of this attempt, if it fails.
  std::optional<TaskFailure> mishap(const TaskRow& task, Surroundings& world) const {
    if (world.is_hopeless(task)) return TaskFailure{};
    TaskFailure failure;
    for (const ArtifactRef& input : task.inputs) {
      if (!world.disk.has(input)) failure.damaged_inputs.push_back(input.hash);
    }
    failure.may_retry = !failure.damaged_inputs.empty() || info_.host == world.bad_host ||
                        world.random.chance(world.trouble.crash);
    failure.killed = !failure.may_retry && world.random.chance(world.trouble.kill);
    const auto attempt = world.rooms.find(attempt_);
    const std::uint64_t room = attempt == world.rooms.end() ? 0 : attempt->second.memory_bytes;
    const std::uint64_t had = room == 0 ? info_.memory_bytes : room;
    if (world.is_giant(task)) failure.peak_rss_bytes = had;
    failure.out_of_memory = world.is_giant(task) || room_of(task) > info_.memory_bytes ||
                            (room_of(task) > had && world.random.chance(world.trouble.hungry));
    failure.out_of_resources = world.random.chance(world.trouble.full_disk);
    const bool fails =
        failure.may_retry || failure.killed || failure.out_of_memory || failure.out_of_resources;
    return fails ? std::optional(failure) : std::nullopt;
  }

  /// First the files are made visible; when they are durable the result is said.
  void finish(Surroundings& world) {
    const TaskRow& task = world.tasks.at(task_);
    if (written_.empty()) {
      if (std::optional<TaskFailure> failure = mishap(task, world)) {
        return fail(std::move(*failure), world);
      }
      result_ = run_make_believe(task);
      result_.seconds = static_cast<double>(world.now_ms - started_ms_) / 1000;
      result_.peak_rss_bytes = room_of(task);
      written_ = result_.outputs;
      for (const ArtifactRef& file : written_) world.disk.rename(file, info_.host);
      finishes_ms_ = world.now_ms + sync_ms;
      if (!written_.empty()) return;
    }
    for (const ArtifactRef& file : written_) world.disk.sync(file);
    unaccepted_ = DoneSaid{task_, attempt_, result_};
    say_result(world);
  }

  void obey(const ToWorker& message, Surroundings& world) {
    if (is_gone_) return;
    heard_ms_ = world.now_ms;
    wakes_ms_ = world.now_ms;
    if (std::holds_alternative<HelloAgain>(message)) {
      is_registered_ = false;
      say_hello(world);
    } else if (const auto* welcome = std::get_if<SendWelcome>(&message)) {
      is_registered_ = true;
      if (!welcome->keep_running) forget();
      if (!attempt_) say_ready_or_leave(world);
    } else if (const auto* accepted = std::get_if<SendAccepted>(&message)) {
      if (!attempt_ || accepted->attempt != attempt_) return;
      if (accepted->taken && !unaccepted_) return;
      const bool waits_for_next = said_ready_ && !is_draining_;
      forget();
      if (!waits_for_next) say_ready_or_leave(world);
    } else if (const auto* assign = std::get_if<SendAssign>(&message)) {
      if (!attempt_ && !is_draining_) start(*assign, world);
    } else if (std::holds_alternative<SendDrain>(message)) {
      start_drain(world);
    }
  }

  WorkerInfo info_;
  int connection_ = 0;
  bool is_gone_ = false;
  bool is_registered_ = false;
  bool is_draining_ = false;
  TaskId task_;
  AttemptId attempt_;
  std::optional<ToCoordinator> unaccepted_;
  bool said_ready_ = false;  // with the result
  TaskResult result_;
  std::vector<ArtifactRef> written_;
  std::vector<ToWorker> waiting_;  // that came while it was stopped
  std::int64_t stopped_until_ms_ = 0;
  std::int64_t wakes_ms_ = 0;
  std::int64_t heard_ms_ = 0;
  std::int64_t hello_ms_ = 0;
  std::int64_t beat_at_ms_ = 0;
  std::int64_t started_ms_ = 0;
  std::int64_t finishes_ms_ = never_ms;
  std::int64_t overdue_ms_ = never_ms;
  std::int64_t drain_until_ms_ = never_ms;
  std::int64_t ends_ms_ = 0;
};

}  // namespace tetfarm::simulation
