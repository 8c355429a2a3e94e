// Days of the life of a farm in a loop: messages lost, doubled, late and out of order, workers that
// die, hang and come back, files that vanish, disks that fill, a coordinator that is killed before
// or after its commit. From each seed the job must end with every task accepted once and the same
// table.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <random>
#include <set>
#include <variant>
#include <vector>

#include "coordinator/job_state.h"
#include "tests/coordinator/durable_record.h"
#include "tests/coordinator/make_believe_task.h"

namespace tetfarm::simulation {

struct Hello {
  TaskId task;
  AttemptId attempt;
};
struct Ready {};
struct Beat {
  TaskId task;
  AttemptId attempt;
};
struct DoneSaid {
  TaskId task;
  AttemptId attempt;
};
struct FailedSaid {
  TaskId task;
  AttemptId attempt;
  TaskFailure failure;
};
struct Bye {};
using ToCoordinator = std::variant<Hello, Ready, Beat, DoneSaid, FailedSaid, Bye>;
struct HelloAgain {};
using ToWorker = std::variant<SendWelcome, SendAssign, SendAccepted, SendDrain, HelloAgain>;

/// A worker process as the protocol describes it; a new one gets a new connection number.
struct FakeWorker {
  int connection = 0;
  bool is_alive = true;
  std::int64_t hangs_until_ms = 0;
  bool is_registered = false;
  bool is_drained = false;
  TaskId task;
  AttemptId attempt;
  std::int64_t finishes_ms = 0;
  std::optional<ToCoordinator> unanswered;
  std::int64_t next_beat_ms = 0;
  std::int64_t heard_ms = 0;
};

struct Trouble {
  double lost = 0;  ///< chance that a message vanishes
  double doubled = 0;
  double death = 0;  ///< chance per worker and step
  double hang = 0;
  double crash = 0;    ///< chance that an attempt ends in a crash or a kill
  double restart = 0;  ///< chance per step that the coordinator dies
  double vanish = 0;   ///< chance per step that a file vanishes
  double full_disk = 0;
  double jump = 0;  ///< chance per step that the clock leaps ahead
  std::int64_t latest_ms = 20;
};

class Farm {
 public:
  Farm(std::uint64_t seed, const Trouble& trouble, const ArtifactRef& job)
      : random_(seed), trouble_(trouble), job_(job) {
    rules_.lease_ms = 1000;
    rules_.max_crashes = 100000;
    rules_.max_losses = 100000;
    rules_.crash_delay_ms = 50;
    rules_.loss_delay_ms = 10;
    rules_.longest_delay_ms = 500;
    rules_.elsewhere_ms = 300;
    files_.insert(job_.hash);
    files_.insert(surface_.hash);
    start_coordinator();
    for (int i = 0; i < 4; ++i) start_worker();
    submit();
  }

  /// True when the job has come to an end.
  bool step() {
    now_.steady_ms += 1 + pick(40);
    if (chance(trouble_.jump)) now_.steady_ms += 3000;
    now_.wall_ms = 7 + now_.steady_ms;
    if (chance(trouble_.restart)) start_coordinator();
    if (chance(trouble_.vanish)) lose_a_file();
    deliver();
    for (FakeWorker& worker : workers_) live(worker);
    while (std::count_if(workers_.begin(), workers_.end(),
                         [](const FakeWorker& worker) { return worker.is_alive; }) < 3) {
      start_worker();
    }
    if (record_.state().jobs.empty()) submit();  // the client had no answer
    turn();
    const auto& jobs = record_.state().jobs;
    return !jobs.empty() && jobs.begin()->second.phase != JobPhase::running;
  }

  std::string report() const {
    std::string text;
    for (const auto& [id, task] : record_.state().tasks) {
      text += std::to_string(id.value) + " " + name_of(task.kind) + " " + name_of(task.state) +
              " attempt " + std::to_string(task.attempt.value) + " " + task.message + "\n";
    }
    for (const FakeWorker& worker : workers_) {
      if (!worker.is_alive) continue;
      text += "worker " + std::to_string(worker.connection) + " attempt " +
              std::to_string(worker.attempt.value) + (worker.unanswered ? " waits" : "") + "\n";
    }
    return text;
  }
  void calm() { trouble_ = Trouble{}; }
  const DurableRecord& record() const { return record_; }
  std::size_t accepted(TaskId task) const {
    const auto found = accepted_.find(task);
    return found == accepted_.end() ? 0 : found->second;
  }
  std::size_t remade(TaskId task) const {
    const auto found = remade_.find(task);
    return found == remade_.end() ? 0 : found->second;
  }

 private:
  struct Travelling {
    std::int64_t arrives_ms = 0;
    int connection = 0;
    std::variant<ToCoordinator, ToWorker> message;
  };

  bool chance(double probability) {
    return std::uniform_real_distribution<double>(0, 1)(random_) < probability;
  }
  std::int64_t pick(std::int64_t count) {
    return std::uniform_int_distribution<std::int64_t>(0, count - 1)(random_);
  }

  void start_coordinator() {
    connection2worker_.clear();
    state_ = std::make_unique<JobState>(
        record_.state(), rules_,
        [this](const ArtifactRef& file) { return files_.contains(file.hash); }, now_);
    EXPECT_THAT(state_->validate(), testing::IsEmpty());
  }

  void submit() { state_->submit({"key", "wing", "", job_, {surface_}}, now_); }

  void start_worker() {
    FakeWorker worker;
    worker.connection = ++last_connection_;
    worker.heard_ms = now_.steady_ms;
    workers_.push_back(worker);
    say(worker, Hello{});
  }

  void lose_a_file() {
    if (files_.size() < 3) return;
    auto file = files_.begin();
    std::advance(file, pick(static_cast<std::int64_t>(files_.size())));
    if (*file != job_.hash && *file != surface_.hash) files_.erase(file);
  }

  template <class Message>
  void post(int connection, const Message& message) {
    if (chance(trouble_.lost)) return;
    const int copies = chance(trouble_.doubled) ? 2 : 1;
    for (int i = 0; i < copies; ++i) {
      travelling_.push_back({now_.steady_ms + pick(trouble_.latest_ms), connection, message});
    }
  }
  void say(const FakeWorker& worker, const ToCoordinator& message) {
    post(worker.connection, message);
  }

  void deliver() {
    std::vector<Travelling> due;
    std::erase_if(travelling_, [&](const Travelling& message) {
      if (message.arrives_ms > now_.steady_ms) return false;
      due.push_back(message);
      return true;
    });
    std::shuffle(due.begin(), due.end(), random_);
    for (const Travelling& message : due) {
      if (const auto* up = std::get_if<ToCoordinator>(&message.message)) {
        receive(message.connection, *up);
      } else {
        for (FakeWorker& worker : workers_) {
          const bool hears = worker.connection == message.connection && worker.is_alive &&
                             worker.hangs_until_ms <= now_.steady_ms;
          if (hears) obey(worker, std::get<ToWorker>(message.message));
        }
      }
    }
  }

  // ---- what the server does
  void receive(int connection, const ToCoordinator& message) {
    const auto known = connection2worker_.find(connection);
    const bool is_known = known != connection2worker_.end() && state_->knows_worker(known->second);
    if (const auto* hello = std::get_if<Hello>(&message)) {
      if (is_known) {
        state_->greet_again(known->second, {}, hello->task, hello->attempt, now_);
      } else {
        connection2worker_[connection] = state_->add_worker({}, hello->task, hello->attempt, now_);
      }
      return;
    }
    if (!is_known) {
      post(connection, ToWorker{HelloAgain{}});
      return;
    }
    const WorkerId worker = known->second;
    if (std::holds_alternative<Ready>(message)) state_->worker_is_ready(worker, now_);
    if (std::holds_alternative<Bye>(message)) state_->worker_left(worker, false, now_);
    if (const auto* beat = std::get_if<Beat>(&message)) {
      state_->heartbeat(worker, beat->task, beat->attempt, now_);
    }
    if (const auto* done = std::get_if<DoneSaid>(&message)) {
      const TaskRow& task = state_->durable().tasks.at(done->task);
      state_->done(worker, done->task, done->attempt, run_make_believe(task), now_);
    }
    if (const auto* failed = std::get_if<FailedSaid>(&message)) {
      state_->failed(worker, failed->task, failed->attempt, failed->failure, now_);
    }
  }

  void turn() {
    state_->tick(now_);
    const std::vector<std::string> broken = state_->validate();
    EXPECT_TRUE(broken.empty()) << broken.front();
    const ChangeSet changes = state_->take_changes();
    const std::vector<Command> commands = state_->take_commands();
    if (chance(trouble_.restart)) return start_coordinator();  // killed before the commit
    for (const AttemptRow& attempt : changes.attempts) {
      if (attempt.state == AttemptState::done) ++accepted_[attempt.task];
    }
    for (const EventRow& event : changes.events) {
      if (event.what == "again") ++remade_[event.task];
    }
    record_.apply(changes);
    if (chance(trouble_.restart)) return start_coordinator();  // killed before the replies
    for (const Command& command : commands) {
      const WorkerId worker = std::visit([](const auto& any) { return any.worker; }, command);
      for (const auto& [connection, id] : connection2worker_) {
        if (id != worker) continue;
        post(connection, std::visit([](const auto& any) -> ToWorker { return any; }, command));
      }
    }
  }

  // ---- what a worker does
  void live(FakeWorker& worker) {
    if (!worker.is_alive) return;
    if (chance(trouble_.death)) worker.is_alive = false;
    if (chance(trouble_.hang)) worker.hangs_until_ms = now_.steady_ms + pick(5000);
    if (!worker.is_alive || worker.hangs_until_ms > now_.steady_ms) return;
    if (worker.attempt && !worker.unanswered && now_.steady_ms >= worker.finishes_ms) {
      finish(worker);
    }
    if (now_.steady_ms < worker.next_beat_ms) return;
    worker.next_beat_ms = now_.steady_ms + 100;
    if (!worker.is_registered || now_.steady_ms > worker.heard_ms + 3000) {
      say(worker, Hello{worker.task, worker.attempt});
      return;
    }
    if (worker.unanswered) {
      say(worker, *worker.unanswered);
    } else if (!worker.attempt) {
      if (chance(trouble_.death)) {
        say(worker, Bye{});
        worker.is_alive = false;
        return;
      }
      say(worker, Ready{});
    }
    say(worker, Beat{worker.task, worker.attempt});
  }

  void finish(FakeWorker& worker) {
    const auto task = record_.state().tasks.find(worker.task);
    ASSERT_NE(task, record_.state().tasks.end());
    TaskFailure failure;
    failure.message = "make-believe";
    for (const ArtifactRef& input : task->second.inputs) {
      if (!files_.contains(input.hash)) failure.damaged_inputs.push_back(input.hash);
    }
    failure.may_retry = !failure.damaged_inputs.empty();
    if (chance(trouble_.crash)) {
      failure.may_retry = true;
      failure.killed = chance(0.5);
    } else if (chance(trouble_.full_disk)) {
      failure.out_of_resources = true;
    }
    if (failure.may_retry || failure.out_of_resources) {
      worker.unanswered = FailedSaid{worker.task, worker.attempt, failure};
    } else {
      for (const ArtifactRef& file : run_make_believe(task->second).outputs) {
        files_.insert(file.hash);
      }
      worker.unanswered = DoneSaid{worker.task, worker.attempt};
    }
    say(worker, *worker.unanswered);
  }

  void obey(FakeWorker& worker, const ToWorker& message) {
    worker.heard_ms = now_.steady_ms;
    const auto forget = [&worker] {
      worker.task = {};
      worker.attempt = {};
      worker.unanswered.reset();
    };
    if (std::holds_alternative<HelloAgain>(message)) {
      worker.is_registered = false;
      say(worker, Hello{worker.task, worker.attempt});
    } else if (const auto* welcome = std::get_if<SendWelcome>(&message)) {
      worker.is_registered = true;
      if (!welcome->keep_running) forget();
    } else if (const auto* accepted = std::get_if<SendAccepted>(&message)) {
      if (accepted->attempt == worker.attempt) forget();
    } else if (const auto* assign = std::get_if<SendAssign>(&message)) {
      if (worker.attempt) return;
      worker.task = assign->task;
      worker.attempt = assign->attempt;
      worker.finishes_ms = now_.steady_ms + 20 + pick(chance(0.1) ? 5000 : 600);
    }
  }

  std::mt19937_64 random_;
  Trouble trouble_;
  FarmRules rules_;
  Moment now_{1000000, 1000007};
  DurableRecord record_;
  std::unique_ptr<JobState> state_;
  std::map<int, WorkerId> connection2worker_;
  int last_connection_ = 0;
  std::vector<FakeWorker> workers_;
  std::vector<Travelling> travelling_;
  std::set<std::string> files_;
  std::map<TaskId, std::size_t> accepted_;
  std::map<TaskId, std::size_t> remade_;
  ArtifactRef job_;
  ArtifactRef surface_ = make_believe_file("input_surface", "flange");
};

/// What must not depend on the course of events.
inline std::string final_table(const DurableState& state) {
  std::map<std::string, std::string> lines;
  for (const auto& [id, task] : state.tasks) {
    std::string line;
    for (const ArtifactRef& file : task.outputs) line += " " + file.name + "=" + file.hash;
    const auto table = task.parameters.find("table");
    if (table != task.parameters.end()) line += "\n" + table->second;
    lines[std::string(name_of(task.kind)) + " " + std::to_string(task.path)] = line;
  }
  std::string text;
  for (const auto& [name, line] : lines) text += name + " " + line + "\n";
  return text;
}

inline Trouble trouble_of(std::uint64_t seed) {
  std::mt19937_64 random(seed * 7919);
  const auto some = [&random](double most) {
    return random() % 3 == 0 ? 0.0 : std::uniform_real_distribution<double>(0, most)(random);
  };
  Trouble trouble;
  trouble.lost = some(0.3);
  trouble.doubled = some(0.3);
  trouble.death = some(0.01);
  trouble.hang = some(0.01);
  trouble.crash = some(0.3);
  trouble.restart = some(0.02);
  trouble.vanish = some(0.02);
  trouble.full_disk = some(0.2);
  trouble.jump = some(0.005);
  trouble.latest_ms = 1 + static_cast<std::int64_t>(some(2000));
  return trouble;
}

inline void run_to_the_end(Farm& farm, std::uint64_t seed) {
  constexpr int wild_steps = 4000;
  constexpr int calm_steps = 20000;
  for (int i = 0; i < wild_steps; ++i) {
    if (farm.step() || testing::Test::HasFailure()) return;
  }
  farm.calm();
  for (int i = 0; i < calm_steps; ++i) {
    if (farm.step() || testing::Test::HasFailure()) return;
  }
  FAIL() << "the job of seed " << seed << " does not come to an end\n" << farm.report();
}

/// Runs the farm from each of the seeds and compares its end with that of a farm without trouble.
inline void expect_the_same_end(std::uint64_t first_seed, std::uint64_t count,
                                const ArtifactRef& job) {
  Farm undisturbed(1, Trouble{}, job);
  run_to_the_end(undisturbed, 0);
  const std::string expected = final_table(undisturbed.record().state());
  ASSERT_FALSE(testing::Test::HasFailure());
  ASSERT_GE(undisturbed.record().state().tasks.size(), 15U) << expected;
  for (std::uint64_t seed = first_seed; seed < first_seed + count; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Farm farm(seed, trouble_of(seed), job);
    run_to_the_end(farm, seed);
    const DurableState& state = farm.record().state();
    EXPECT_EQ(state.jobs.begin()->second.phase, JobPhase::done)
        << state.jobs.begin()->second.message;
    EXPECT_EQ(final_table(state), expected);
    for (const auto& [id, task] : state.tasks) {
      // A lost file that turned out not to be needed may still be in the making.
      const std::size_t in_the_making = task.state == TaskState::done ? 0 : 1;
      EXPECT_EQ(farm.accepted(id) + in_the_making, 1 + farm.remade(id)) << "task " << id.value;
    }
    if (testing::Test::HasFailure()) return;
  }
}

}  // namespace tetfarm::simulation
