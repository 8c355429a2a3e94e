// The coordinator's process: the real decisions and database, and the few lines that stand between
// them and the network (coordinator/server.cpp, request_handler.cpp), without sockets. It is killed
// at any point: while it starts, before, within and after a commit, between two replies.
//
// Its steady clock starts anew with each process, earlier or later, and leaps ahead when its host
// sleeps; it never goes back within a process, as the kernel promises. The wall clock is set by
// whoever likes to, forward and back.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "tests/coordinator/farm_invariants.h"
#include "tests/coordinator/simulated_world.h"

namespace tetfarm::simulation {

class Coordinator {
 public:
  /// What it shares with the rest of the farm.
  struct Farm {
    Random& random;
    const Trouble& trouble;
    const Disk& disk;
    Invariants& invariants;
    FarmDatabase& database;
    const std::vector<Submission>& jobs;
    const std::int64_t& now_ms;
    std::function<void(int, ToWorker)> post;
    std::function<bool(int)> can_reach;
  };

  Coordinator(Farm farm, const FarmRules& rules) : farm_(std::move(farm)), rules_(rules) {
    restore(farm_.database.load());
  }

  void leap(std::int64_t by_ms) { steady_offset_ms_ += by_ms; }
  void set_wall_clock(std::int64_t by_ms) { wall_offset_ms_ += by_ms; }
  WorkerId any_worker() const {
    return worker2connection_.empty() ? WorkerId{} : worker2connection_.begin()->first;
  }

  /// What RequestHandler does with a message.
  void receive(int connection, const ToCoordinator& message) {
    if (heed_client(message)) return;
    const auto known = connection2worker_.find(connection);
    const WorkerId worker = known == connection2worker_.end() ? WorkerId{} : known->second;
    const bool is_known = worker && state_->knows_worker(worker);
    if (const auto* hello = std::get_if<Hello>(&message)) {
      if (is_known) {
        state_->greet_again(worker, hello->info, hello->task, hello->attempt, moment());
      } else {
        forget(worker);
        const WorkerId added =
            state_->add_worker(hello->info, hello->task, hello->attempt, moment());
        connection2worker_[connection] = added;
        worker2connection_[added] = connection;
      }
    } else if (!is_known) {
      forget(worker);
      if (!std::holds_alternative<Bye>(message)) farm_.post(connection, HelloAgain{});
    } else {
      heed_worker(worker, message);
    }
  }

  /// What Server does in a turn, after it has received.
  void turn() {
    state_->tick(moment());
    const ChangeSet changes = state_->take_changes();
    const std::vector<Command> commands = state_->take_commands();
    const bool is_worth_a_look = !changes.empty() || !commands.empty();
    if (is_worth_a_look) validate();
    if (farm_.random.chance(farm_.trouble.restart)) return restart();  // before the commit
    if (!changes.empty() && !commit(changes)) return;
    for (const Command& command : commands) {
      farm_.invariants.spoken_after_commit(command, farm_.database.record());
      if (farm_.random.chance(farm_.trouble.restart / 4)) return restart();  // between replies
      send(command);
    }
  }

 private:
  Moment moment() const {
    return {farm_.now_ms + steady_offset_ms_, farm_.now_ms + wall_offset_ms_};
  }

  void validate() {
    const std::vector<std::string> broken = state_->validate();
    EXPECT_TRUE(broken.empty()) << broken.front();
  }

  /// Also in the middle of a start: what was not committed never happened.
  void restart() {
    do {
      steady_offset_ms_ = farm_.random.pick(2000000) - 900000;
      const bool after_blackout = farm_.random.chance(farm_.trouble.blackout);
      restore(farm_.database.open(after_blackout));
    } while (farm_.random.chance(farm_.trouble.restart * 3));
  }

  /// A process that knows nothing yet.
  void restore(const DurableState& found) {
    finished_ = FinishedJobs({[this](JobId job) { return farm_.database.load_job(job); },
                              [this](TaskId task) { return farm_.database.find_task(task); }});
    decide_anew(found);
  }

  void decide_anew(const DurableState& found) {
    connection2worker_.clear();
    worker2connection_.clear();
    if (const auto late = farm_.database.take_found()) {
      farm_.invariants.found_after_a_restart(*late, farm_.database.record());
    }
    DurableState rows = farm_.database.load_unfinished();
    finished_.put_others_than(rows);
    state_ = std::make_unique<JobState>(
        std::move(rows), rules_, [this](const ArtifactRef& file) { return farm_.disk.has(file); },
        moment(), &finished_);
    farm_.invariants.resumable(found, *state_);
  }

  Fault next_fault() {
    const Trouble& trouble = farm_.trouble;
    if (farm_.random.chance(trouble.restart / 2)) return Fault::killed;
    if (farm_.random.chance(trouble.commit_full)) return Fault::full;
    if (farm_.random.chance(trouble.commit_busy)) return Fault::busy;
    if (farm_.random.chance(trouble.commit_broken)) return Fault::broken;
    return Fault::none;
  }

  /// A full disk and a locked database are waited for, as in Server::commit; anything else ends the
  /// process.
  bool commit(const ChangeSet& changes) {
    try {
      farm_.database.apply(changes, next_fault());
    } catch (const IoError& error) {
      const bool can_wait =
          error.code() == ExitCode::out_of_resources || error.error_number() == EBUSY;
      if (!can_wait) {
        restart();
        return false;
      }
      decide_anew(farm_.database.load());
      state_->hold_back(error.what(), moment());
      return false;
    }
    farm_.invariants.committed(changes, farm_.database.record(), farm_.disk);
    for (const DurableState& job : state_->take_finished()) finished_.put(job);
    return true;
  }

  void send(const Command& command) {
    const WorkerId worker = std::visit([](const auto& any) { return any.worker; }, command);
    const auto connection = worker2connection_.find(worker);
    if (connection == worker2connection_.end()) return;
    // ROUTER often knows that there is nobody at the other end.
    if (!farm_.can_reach(connection->second) && farm_.random.chance(0.5)) {
      const bool is_assign = std::holds_alternative<SendAssign>(command);
      if (is_assign) state_->worker_left(worker, true, moment());
      return;
    }
    farm_.post(connection->second,
               std::visit([](const auto& any) -> ToWorker { return any; }, command));
  }

  void forget(WorkerId worker) {
    const auto connection = worker2connection_.find(worker);
    if (connection == worker2connection_.end()) return;
    connection2worker_.erase(connection->second);
    worker2connection_.erase(connection);
  }

  void heed_worker(WorkerId worker, const ToCoordinator& message) {
    if (std::holds_alternative<Ready>(message)) {
      state_->worker_is_ready(worker, moment());
    } else if (const auto* beat = std::get_if<Beat>(&message)) {
      state_->heartbeat(worker, beat->task, beat->attempt, moment());
      // Late and doubled messages say less than was known.
      const auto done = static_cast<std::uint64_t>(moment().steady_ms % 100);
      state_->note_work(worker, beat->task, beat->attempt, {WorkStage::edges, 0, done, 100});
    } else if (const auto* done = std::get_if<DoneSaid>(&message)) {
      state_->done(worker, done->task, done->attempt, done->result, moment());
    } else if (const auto* failed = std::get_if<FailedSaid>(&message)) {
      take_failure(worker, *failed);
    } else if (std::holds_alternative<Bye>(message)) {
      state_->worker_left(worker, false, moment());
      forget(worker);
    }
  }

  /// As RequestHandler::failed: inputs that are whole here were not damaged.
  void take_failure(WorkerId worker, const FailedSaid& message) {
    TaskFailure failure = message.failure;
    const std::size_t claimed = failure.damaged_inputs.size();
    const auto task = state_->durable().tasks.find(message.task);
    if (task != state_->durable().tasks.end()) {
      for (const ArtifactRef& input : task->second.inputs) {
        if (farm_.disk.has(input)) std::erase(failure.damaged_inputs, input.hash);
      }
    }
    if (failure.damaged_inputs.empty() && claimed > 0) failure.killed = true;
    state_->failed(worker, message.task, message.attempt, failure, moment());
  }

  bool heed_client(const ToCoordinator& message) {
    if (const auto* submit = std::get_if<SubmitSaid>(&message)) {
      state_->submit(farm_.jobs[static_cast<std::size_t>(submit->job)], moment());
    } else if (const auto* cancel = std::get_if<CancelSaid>(&message)) {
      state_->cancel(cancel->job, moment());
    } else if (const auto* retry = std::get_if<RetrySaid>(&message)) {
      state_->retry(retry->job, retry->task, moment());
    } else if (const auto* let_go = std::get_if<LetGoSaid>(&message)) {
      state_->release_host(let_go->host, moment());
    } else if (const auto* drain = std::get_if<DrainSaid>(&message)) {
      state_->drain(drain->worker);
    } else {
      return false;
    }
    return true;
  }

  Farm farm_;
  FarmRules rules_;
  std::int64_t steady_offset_ms_ = 0;
  std::int64_t wall_offset_ms_ = 7;
  FinishedJobs finished_;
  std::unique_ptr<JobState> state_;
  std::map<int, WorkerId> connection2worker_;
  std::map<WorkerId, int> worker2connection_;
};

}  // namespace tetfarm::simulation
