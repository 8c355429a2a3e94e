// A worker process: the real decisions (worker/decisions/worker_state.h), and what stands between
// them and the world (worker/client.cpp) without sockets, processes and files: connections, the
// child that does its task, the files that go over the connection when it does not see the store.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "base/error.h"
#include "tasks/failure_cause.h"
#include "tests/coordinator/fake_task.h"
#include "tests/coordinator/simulated_world.h"
#include "worker/decisions/worker_state.h"

namespace tetfarm::simulation {

constexpr std::int64_t grace_ms = 400;
constexpr std::int64_t sync_ms = 5;
constexpr std::int64_t never_ms = WorkerState::never_ms;

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
  std::function<void(int, Message)> post;
  std::function<int()> new_connection;
};

/// What a task takes: the same at each try.
inline std::uint64_t room_of(const TaskRow& task) {
  const std::uint64_t lot =
      hash128(std::string(name_of(task.kind)) + std::to_string(task.path)).low;
  return (lot % 9 == 0 ? 700 : 100 + lot % 100) << 20U;
}

inline wire::Hello hello_of(const WorkerInfo& info) {
  wire::Hello hello;
  hello.set_host(info.host);
  hello.set_nonce(info.nonce);
  hello.set_memory_bytes(info.memory_bytes);
  hello.set_own_memory(!info.shares_memory);
  return hello;
}

inline wire::Envelope done_message(const wire::Assign& assign, const TaskResult& result) {
  wire::Envelope envelope;
  wire::Done& done = *envelope.mutable_done();
  done.set_task(assign.task());
  done.set_attempt(assign.attempt());
  for (const ArtifactRef& file : result.outputs) {
    wire::Artifact& output = *done.add_outputs();
    output.set_name(file.name);
    output.set_hash(file.hash);
    output.set_size(file.size);
  }
  done.mutable_numbers()->insert(result.numbers.begin(), result.numbers.end());
  done.mutable_texts()->insert(result.texts.begin(), result.texts.end());
  done.set_seconds(result.seconds);
  done.set_peak_rss_bytes(result.peak_rss_bytes);
  return envelope;
}

inline wire::Envelope failed_message(const wire::Assign& assign, const TaskFailure& failure) {
  wire::Envelope envelope;
  wire::Failed& failed = *envelope.mutable_failed();
  failed.set_task(assign.task());
  failed.set_attempt(assign.attempt());
  failed.set_message("make-believe");
  failed.set_exit_code(failure.exit_code);
  failed.set_cause(on_wire(failure.cause));
  failed.set_peak_rss_bytes(failure.peak_rss_bytes);
  for (const std::string& hash : failure.damaged_inputs) failed.add_damaged_inputs(hash);
  return envelope;
}

class Worker {
 public:
  Worker(const WorkerInfo& info, bool sees_store, Surroundings& world)
      : host_(info.host),
        nonce_(info.nonce),
        memory_bytes_(info.memory_bytes),
        sees_store_(sees_store),
        state_(hello_of(info),
               {.ends_ms = info.ends_in_ms > 0 ? world.now_ms + info.ends_in_ms : 0,
                .grace_ms = grace_ms},
               world.now_ms) {
    carry_out_all(world);
  }

  int connection() const { return connection_; }
  const std::string& host() const { return host_; }
  const std::string& nonce() const { return nonce_; }
  TaskId task() const { return TaskId{assign_.task()}; }
  AttemptId attempt() const { return AttemptId{assign_.attempt()}; }
  bool is_gone() const { return state_.phase() == WorkerPhase::gone; }
  bool is_stopped(std::int64_t now_ms) const { return now_ms < stopped_until_ms_; }
  void stop(std::int64_t until_ms) { stopped_until_ms_ = until_ms; }
  /// The socket connects anew under the program: the coordinator sees somebody it does not know.
  void change_connection(int connection) { connection_ = connection; }
  /// When it has something to do of itself.
  std::int64_t wakes_ms() const { return std::max(stopped_until_ms_, wakes_ms_); }
  std::string report() const {
    return std::string(name_of(state_.phase())) + ", " + name_of(state_.link());
  }

  void signal(Surroundings& world) {
    state_.signal_came(world.now_ms);
    carry_out_all(world);
  }

  void hear(const Message& message, Surroundings& world) {
    if (is_stopped(world.now_ms)) {
      waiting_.push_back(message);
    } else {
      take(*message, world);
    }
  }

  void live(Surroundings& world) {
    if (world.now_ms < wakes_ms()) return;
    for (const Message& message : std::exchange(waiting_, {})) take(*message, world);
    if (world.now_ms >= connects_ms_) {
      connects_ms_ = never_ms;
      state_.connection_is_there(world.now_ms);
      carry_out_all(world);
    }
    if (child_ && world.now_ms >= child_->wakes_ms) go_on_with_child(world);
    if (world.now_ms >= files_ms_ && state_.may_move_files()) end_files(world);
    state_.tick(world.now_ms);
    carry_out_all(world);
    note_when_it_wakes(world.now_ms);
  }

 private:
  struct Child {
    wire::Assign assign;
    bool is_without_shared_store = false;
    bool is_overdue = false;
    std::int64_t started_ms = 0;
    std::int64_t wakes_ms = 0;
    std::optional<TaskResult> result = {};  ///< whose files are visible, and not yet durable
  };

  void take(const wire::Envelope& message, Surroundings& world) {
    if (message.has_welcome() && world.random.chance(world.trouble.swept)) {
      state_.probe_was_swept_away(world.now_ms);
    } else {
      state_.hear(message, world.now_ms);
    }
    carry_out_all(world);
    wakes_ms_ = world.now_ms;
  }

  void note_when_it_wakes(std::int64_t now_ms) {
    const std::int64_t due_ms = state_.due_ms();
    EXPECT_GT(due_ms, now_ms) << "what was due was not done: " << report();
    wakes_ms_ = std::min(due_ms, connects_ms_);
    if (child_) wakes_ms_ = std::min(wakes_ms_, child_->wakes_ms);
    if (state_.may_move_files()) wakes_ms_ = std::min(wakes_ms_, files_ms_);
    wakes_ms_ = std::max(wakes_ms_, now_ms + 1);
  }

  // ---- what is to be done
  void carry_out_all(Surroundings& world) {
    for (auto commands = state_.take_commands(); !commands.empty();
         commands = state_.take_commands()) {
      for (const WorkerCommand& command : commands) {
        std::visit([&](const auto& one) { carry_out(one, world); }, command);
      }
    }
    const std::vector<std::string> broken = state_.validate();
    EXPECT_TRUE(broken.empty()) << broken.front();
  }

  void carry_out(const ConnectAnew&, Surroundings& world) { connection_ = world.new_connection(); }

  void carry_out(const SayHello& command, Surroundings& world) {
    if (world.random.chance(world.trouble.absent)) {
      state_.hello_was_not_sent();
      connects_ms_ = world.now_ms + world.random.pick(500);
      return;
    }
    world.post(connection_, message_of([&](wire::Envelope& envelope) {
                 *envelope.mutable_hello() = command.hello;
                 if (sees_store_) envelope.mutable_hello()->set_probe_file("probe");
               }));
  }

  void carry_out(const SendMessage& command, Surroundings& world) {
    world.post(connection_,
               message_of([&](wire::Envelope& envelope) { envelope = command.envelope; }));
  }

  void carry_out(const LookForRoom&, Surroundings& world) {
    state_.room_was_looked_for(!world.random.chance(world.trouble.full_disk), world.now_ms);
  }

  void carry_out(const StartChild& command, Surroundings& world) {
    assign_ = command.assign;
    if (world.random.chance(world.trouble.no_process)) {
      return state_.child_did_not_start(Error(ExitCode::failed, "no process"), world.now_ms);
    }
    const bool hangs = world.random.chance(world.trouble.hang);
    const std::int64_t slowest = world.random.chance(0.1) ? 3000 : 300;
    child_ = Child{.assign = command.assign,
                   .is_without_shared_store = command.is_without_shared_store,
                   .started_ms = world.now_ms,
                   .wakes_ms = hangs ? never_ms : world.now_ms + 10 + world.random.pick(slowest)};
  }

  void carry_out(const EndOverdueChild&, Surroundings& world) {
    child_->is_overdue = true;
    child_->wakes_ms = world.now_ms + world.random.pick(50);
  }

  void carry_out(const EndChild&, Surroundings&) { child_.reset(); }

  void carry_out(const FetchInputs& command, Surroundings& world) {
    assign_ = command.assign;
    files_ms_ = world.now_ms + world.random.pick(200);
  }
  void carry_out(const UploadOutputs& command, Surroundings& world) {
    outcome_ = command.outcome;
    files_ms_ = world.now_ms + world.random.pick(200);
  }
  void carry_out(const AskForFilesAgain&, Surroundings&) {}
  void carry_out(const ForgetFiles&, Surroundings&) {
    files_ms_ = never_ms;
    outcome_.Clear();
    if (state_.phase() == WorkerPhase::idle || is_gone()) assign_.Clear();
  }
  void carry_out(const TellLog&, Surroundings&) {}
  void carry_out(const ExitWorker& command, Surroundings&) {
    EXPECT_FALSE(command.is_refused) << command.reason;
  }

  // ---- files that go over the connection
  void end_files(Surroundings& world) {
    files_ms_ = never_ms;
    if (world.random.chance(world.trouble.bad_files)) {
      const bool is_damaged = world.random.chance(0.5);
      const ExitCode code = is_damaged ? ExitCode::failed : ExitCode::out_of_resources;
      state_.files_failed(Error(code, "make-believe"), is_damaged, world.now_ms);
    } else if (state_.phase() == WorkerPhase::fetching) {
      end_fetch(world);
    } else {
      for (const wire::Artifact& file : outcome_.done().outputs()) {
        const ArtifactRef output{file.name(), file.hash(), file.size()};
        world.disk.rename(output, "coordinator");
        world.disk.sync(output);
      }
      state_.outputs_went(world.now_ms);
    }
    carry_out_all(world);
  }

  void end_fetch(Surroundings& world) {
    for (const wire::Artifact& file : assign_.inputs()) {
      if (world.disk.has({file.name(), file.hash(), file.size()})) continue;
      return state_.input_is_damaged(file.hash(), world.now_ms);
    }
    state_.inputs_came(world.now_ms);
  }

  // ---- the child
  void end_child(wire::Envelope outcome, Surroundings& world) {
    child_.reset();
    state_.child_ended(std::move(outcome), world.now_ms);
    carry_out_all(world);
  }

  /// First the files are made visible; when they are durable the result is said.
  void go_on_with_child(Surroundings& world) {
    const wire::Assign assign = child_->assign;
    if (child_->is_overdue) {
      TaskFailure failure;
      failure.cause = FailureCause::error;
      return end_child(failed_message(assign, failure), world);
    }
    const TaskRow& task = world.tasks.at(TaskId{assign.task()});
    if (!child_->result) {
      if (const std::optional<TaskFailure> failure = mishap(task, world)) {
        return end_child(failed_message(assign, *failure), world);
      }
      TaskResult& result = child_->result.emplace(run_fake_task(task));
      result.seconds = static_cast<double>(world.now_ms - child_->started_ms) / 1000;
      result.peak_rss_bytes = room_of(task);
      if (!child_->is_without_shared_store) {
        for (const ArtifactRef& file : result.outputs) world.disk.rename(file, host_);
        child_->wakes_ms = world.now_ms + sync_ms;
        if (!result.outputs.empty()) return;
      }
    }
    const TaskResult result = std::move(*child_->result);
    if (!child_->is_without_shared_store) {
      for (const ArtifactRef& file : result.outputs) world.disk.sync(file);
    }
    end_child(done_message(assign, result), world);
  }

  /// The failure of this attempt, if it fails.
  std::optional<TaskFailure> mishap(const TaskRow& task, Surroundings& world) const {
    if (world.is_hopeless(task)) return TaskFailure{};
    TaskFailure failure;
    for (const ArtifactRef& input : task.inputs) {
      // What has been fetched is the worker's own.
      const bool is_at_hand = child_->is_without_shared_store || world.disk.has(input);
      if (!is_at_hand) failure.damaged_inputs.push_back(input.hash);
    }
    const bool errs = !failure.damaged_inputs.empty() || host_ == world.bad_host ||
                      world.random.chance(world.trouble.crash);
    const bool killed = !errs && world.random.chance(world.trouble.kill);
    const auto attempt = world.rooms.find(AttemptId{child_->assign.attempt()});
    const std::uint64_t room = attempt == world.rooms.end() ? 0 : attempt->second.memory_bytes;
    const std::uint64_t had = room == 0 ? memory_bytes_ : room;
    if (world.is_giant(task)) failure.peak_rss_bytes = had;
    const bool starves = world.is_giant(task) || room_of(task) > memory_bytes_ ||
                         (room_of(task) > had && world.random.chance(world.trouble.hungry));
    const bool is_full = world.random.chance(world.trouble.full_disk);
    if (!errs && !killed && !starves && !is_full) return std::nullopt;
    failure.cause = !failure.damaged_inputs.empty() ? FailureCause::damaged_input
                    : starves                       ? FailureCause::out_of_memory
                    : is_full                       ? FailureCause::disk_full
                    : killed                        ? FailureCause::killed
                                                    : FailureCause::error;
    return failure;
  }

  std::string host_;
  std::string nonce_;
  std::uint64_t memory_bytes_;
  bool sees_store_;
  WorkerState state_;
  int connection_ = 0;
  wire::Assign assign_;  ///< that it holds; empty: none
  std::optional<Child> child_;
  std::int64_t files_ms_ = never_ms;     ///< when files that go have gone
  wire::Envelope outcome_;               ///< whose files go
  std::int64_t connects_ms_ = never_ms;  ///< when somebody is at the other end
  std::vector<Message> waiting_;         ///< that came while it was stopped
  std::int64_t stopped_until_ms_ = 0;
  std::int64_t wakes_ms_ = 0;
};

}  // namespace tetfarm::simulation
