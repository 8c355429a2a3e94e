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
#include <set>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "coordinator/decisions/message_translation.h"
#include "tasks/failure_cause.h"
#include "tests/coordinator/farm_invariants.h"
#include "tests/coordinator/simulated_world.h"

namespace tetfarm::simulation {

constexpr std::int64_t beat_ms = 250;

class Coordinator {
 public:
  /// What it shares with the rest of the farm.
  struct Farm {
    Random& random;
    const Trouble& trouble;
    Disk& disk;
    Invariants& invariants;
    FarmDatabase& database;
    const std::vector<Submission>& jobs;
    const std::int64_t& now_ms;
    std::function<void(int, Message)> post;
    std::function<bool(int)> can_reach;
    bool second_waits = false;  ///< of the jobs, for the first
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
    const wire::Envelope& envelope = *std::get<Message>(message);
    const auto known = connection2worker_.find(connection);
    const WorkerId worker = known == connection2worker_.end() ? WorkerId{} : known->second;
    const bool is_known = worker && state_->knows_worker(worker);
    if (envelope.has_hello()) {
      heed_hello(connection, is_known ? worker : WorkerId{}, envelope.hello());
    } else if (!is_known) {
      forget(worker);
      if (!envelope.has_goodbye()) say_hello_again(connection);
    } else {
      heed_worker(worker, envelope);
    }
  }

  /// What Server does in a turn, after it has received.
  void turn() {
    for (const std::string& hash : std::exchange(spared_, {})) state_->consider_file(hash);
    state_->tick(moment());
    const ChangeSet changes = state_->take_changes();
    const std::vector<std::string> unneeded = state_->take_unneeded_files();
    const std::vector<Command> commands = state_->take_commands();
    const std::vector<Message> messages = words_for(commands);
    const bool is_worth_a_look = !changes.empty() || !commands.empty();
    if (is_worth_a_look) validate();
    if (farm_.random.chance(farm_.trouble.restart)) return restart();  // before the commit
    if (!changes.empty() && !commit(changes)) return;
    files_to_remove_.insert(unneeded.begin(), unneeded.end());
    remove_files(0.3);
    for (std::size_t i = 0; i < commands.size(); ++i) {
      farm_.invariants.spoken_after_commit(commands[i], farm_.database.record());
      if (farm_.random.chance(farm_.trouble.restart / 4)) return restart();  // between replies
      send(commands[i], messages[i]);
    }
  }

  /// What RemovalThread does beside the turns, and does not come to when the process is killed.
  void remove_files(double share) {
    for (auto next = files_to_remove_.begin(); next != files_to_remove_.end();) {
      const auto file = next++;
      if (!removal_random_.chance(share)) continue;
      farm_.invariants.removed(*file, farm_.database.record(), rules_.keeps_all_files);
      farm_.disk.remove(*file);
      files_to_remove_.erase(file);
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
                              [this](TaskId task) { return farm_.database.find_task(task); }},
                             rules_.keeps_all_files);
    files_to_remove_.clear();
    spared_.clear();
    decide_anew(found);
  }

  void decide_anew(const DurableState& found) {
    connection2worker_.clear();
    worker2connection_.clear();
    blind_.clear();
    answered_ms_.clear();
    if (const auto late = farm_.database.take_found()) {
      farm_.invariants.found_after_a_restart(*late, farm_.database.record());
    }
    DurableState rows = farm_.database.load_unfinished();
    finished_.put_others_than(rows,
                              [this](const ArtifactRef& file) { return farm_.disk.has(file); });
    state_ = std::make_unique<JobState>(
        std::move(rows), rules_, [this](const ArtifactRef& file) { return has_file(file); },
        moment(), &finished_);
    for (const std::string& hash : finished_.take_leavings()) state_->consider_file(hash);
    farm_.invariants.resumable(found, *state_);
  }

  /// A file that somebody asks for is not removed now.
  bool has_file(const ArtifactRef& file) {
    if (files_to_remove_.erase(file.hash) > 0) spared_.push_back(file.hash);
    return farm_.disk.has(file);
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

  void send(const Command& command, const Message& message) {
    const WorkerId worker = std::visit([](const auto& any) { return any.worker; }, command);
    const auto connection = worker2connection_.find(worker);
    if (connection == worker2connection_.end()) return;
    // ROUTER often knows that there is nobody at the other end.
    if (!farm_.can_reach(connection->second) && farm_.random.chance(0.5)) {
      const bool is_assign = std::holds_alternative<SendAssign>(command);
      if (is_assign) state_->worker_left(worker, true, moment());
      return;
    }
    farm_.post(connection->second, message);
  }

  // ---- what was decided, as RequestHandler puts it into words, before the commit
  std::vector<Message> words_for(const std::vector<Command>& commands) const {
    std::vector<Message> messages;
    for (const Command& command : commands) {
      messages.push_back(std::visit([this](const auto& any) { return message_for(any); }, command));
    }
    return messages;
  }
  Message message_for(const SendWelcome& welcome) const {
    return message_of([&](wire::Envelope& envelope) {
      wire::Welcome& message = *envelope.mutable_welcome();
      message.set_worker(welcome.worker.value);
      message.set_heartbeat_ms(static_cast<std::uint32_t>(beat_ms));
      message.set_lease_ms(static_cast<std::uint32_t>(rules_.lease_ms));
      message.set_keep_running(welcome.keep_running);
      message.set_sees_store(!blind_.contains(welcome.worker));
    });
  }
  Message message_for(const SendAssign& assign) const {
    return message_of([&](wire::Envelope& envelope) {
      envelope = assign_message(state_->durable().tasks.at(assign.task), assign.attempt);
      envelope.mutable_assign()->set_limit_ms(static_cast<std::uint64_t>(assign.limit_ms));
    });
  }
  Message message_for(const SendAccepted& accepted) const {
    return message_of([&](wire::Envelope& envelope) { envelope = accepted_message(accepted); });
  }
  Message message_for(const SendDrain&) const {
    return message_of([](wire::Envelope& envelope) { envelope.mutable_drain(); });
  }

  void say_hello_again(int connection) {
    farm_.post(connection, message_of([](wire::Envelope& envelope) {
                 envelope.mutable_refused()->set_hello_again(true);
               }));
  }

  void forget(WorkerId worker) {
    const auto connection = worker2connection_.find(worker);
    if (connection == worker2connection_.end()) return;
    connection2worker_.erase(connection->second);
    worker2connection_.erase(connection);
    blind_.erase(worker);
    answered_ms_.erase(worker);
  }

  void heed_hello(int connection, WorkerId known, const wire::Hello& hello) {
    const WorkerInfo info = worker_info_of(hello);
    const TaskId task{hello.running_task()};
    const AttemptId attempt{hello.running_attempt()};
    WorkerId worker = known;
    if (known) {
      state_->greet_again(known, info, task, attempt, moment());
    } else {
      const auto before = connection2worker_.find(connection);
      if (before != connection2worker_.end()) forget(before->second);
      worker = state_->add_worker(info, task, attempt, moment());
      connection2worker_[connection] = worker;
      worker2connection_[worker] = connection;
    }
    if (hello.probe_file().empty()) {
      blind_.insert(worker);
    } else {
      blind_.erase(worker);
    }
  }

  void heed_worker(WorkerId worker, const wire::Envelope& envelope) {
    if (envelope.has_ready()) {
      state_->worker_is_ready(worker, moment());
    } else if (envelope.has_heartbeat()) {
      heed_heartbeat(worker, envelope.heartbeat());
    } else if (envelope.has_done()) {
      const wire::Done& done = envelope.done();
      state_->done(worker, TaskId{done.task()}, AttemptId{done.attempt()}, result_of(done),
                   moment());
    } else if (envelope.has_failed()) {
      take_failure(worker, envelope.failed());
    } else if (envelope.has_goodbye()) {
      state_->worker_left(worker, false, moment());
      forget(worker);
    }
  }

  /// As RequestHandler::answer_heartbeat: an answer now and then, which needs no commit.
  void heed_heartbeat(WorkerId worker, const wire::Heartbeat& beat) {
    const TaskId task{beat.task()};
    const AttemptId attempt{beat.attempt()};
    state_->heartbeat(worker, task, attempt, moment());
    // Late and doubled messages say less than was known.
    const auto done = static_cast<std::uint64_t>(moment().steady_ms % 100);
    state_->note_work(worker, task, attempt, {WorkStage::edges, 0, done, 100});
    std::int64_t& answered_ms = answered_ms_[worker];
    if (moment().steady_ms - answered_ms < rules_.lease_ms / 4) return;
    answered_ms = moment().steady_ms;
    farm_.post(worker2connection_.at(worker),
               message_of([&](wire::Envelope& envelope) { *envelope.mutable_heartbeat() = beat; }));
  }

  /// As RequestHandler::failed: inputs that are whole here were not damaged.
  void take_failure(WorkerId worker, const wire::Failed& message) {
    TaskFailure failure = failure_of(message);
    failure.damaged_inputs = {message.damaged_inputs().begin(), message.damaged_inputs().end()};
    const auto task = state_->durable().tasks.find(TaskId{message.task()});
    if (task != state_->durable().tasks.end()) {
      for (const ArtifactRef& input : task->second.inputs) {
        if (farm_.disk.has(input)) std::erase(failure.damaged_inputs, input.hash);
      }
    }
    const bool claims = message.damaged_inputs_size() > 0;
    if (failure.damaged_inputs.empty() && claims) failure.cause = FailureCause::killed;
    state_->failed(worker, TaskId{message.task()}, AttemptId{message.attempt()}, failure, moment());
  }

  /// One that is to wait for a job that is not there yet is not heard; it is said again.
  void take_submission(std::size_t number) {
    Submission submission = farm_.jobs[number];
    if (farm_.second_waits && number == 1) {
      for (const auto& [id, job] : state_->durable().jobs) {
        if (job.key == farm_.jobs.front().key) submission.after = {id};
      }
      if (submission.after.empty()) return;
    }
    state_->submit(submission, moment());
  }

  bool heed_client(const ToCoordinator& message) {
    if (const auto* submit = std::get_if<SubmitSaid>(&message)) {
      take_submission(static_cast<std::size_t>(submit->job));
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
  std::set<WorkerId> blind_;  ///< that do not see the store
  std::map<WorkerId, std::int64_t> answered_ms_;
  std::set<std::string> files_to_remove_;
  std::vector<std::string> spared_;  ///< that were to be removed, and were asked for
  Random removal_random_{1};         ///< so that removals do not change what else happens
};

}  // namespace tetfarm::simulation
