// A whole farm in one process, under a seed: a coordinator with its database
// (simulated_coordinator.h, simulated_database.h), worker processes on several hosts, which decide
// as real ones do (simulated_worker.h), clients, a disk, a network and clocks, all of which fail
// (simulated_world.h). Invariants are asked after every commit and every restart
// (farm_invariants.h).
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "tests/coordinator/simulated_clients.h"
#include "tests/coordinator/simulated_coordinator.h"
#include "tests/coordinator/simulated_worker.h"

namespace tetfarm::simulation {

class Farm {
 public:
  Farm(std::uint64_t seed, const Trouble& trouble, const Wish& wish, bool has_real_database)
      : random_(seed),
        trouble_(trouble),
        wish_(wish),
        database_(has_real_database, Random(seed + 1)),
        rules_(rules_of(trouble)),
        jobs_(submissions()),
        surroundings_(surroundings()),
        coordinator_(shared_with_coordinator(), rules_),
        clients_(random_, trouble_, jobs_, wish_, state(),
                 [this](ToCoordinator message) { post_up(0, std::move(message)); }) {
    for (const ArtifactRef& job : wish_.jobs) disk_.publish_input(job);
    disk_.publish_input(surface());
    while (workers_.size() < 4) start_worker();
  }
  Farm(const Farm&) = delete;
  Farm& operator=(const Farm&) = delete;

  /// True when every job has come to its end.
  bool step() {
    go_to_the_next_event();
    make_trouble();
    deliver();
    for (Worker& worker : workers_) worker.live(surroundings_);
    replace_workers();
    clients_.act(now_ms_, surroundings_.bad_host.empty(), coordinator_.any_worker());
    if (now_ms_ >= turn_ms_ || heard_) {
      heard_ = false;
      turn_ms_ = now_ms_ + longest_turn_ms;
      coordinator_.turn();
    }
    return clients_.are_content();
  }

  /// From now on nothing goes wrong.
  void calm() {
    trouble_ = Trouble{};
    trouble_.is_strict = rules_.max_crashes < 10;
    surroundings_.bad_host.clear();
  }

  const DurableState& state() const { return database_.record().state(); }
  const DurableRecord& record() const { return database_.record(); }
  const Disk& disk() const { return disk_; }
  /// What the coordinator was about to remove.
  void remove_the_rest() { coordinator_.remove_files(1); }
  Invariants& invariants() { return invariants_; }

  std::string report() const {
    std::string text = "at " + std::to_string(now_ms_) + " ms\n";
    for (const auto& [id, job] : state().jobs) {
      text += job.key + " " + name_of(job.phase) + " " + job.message.substr(0, 200) + "\n";
    }
    for (const auto& [id, task] : state().tasks) {
      text += std::to_string(id.value) + " " + name_of(task.kind) + " " +
              std::to_string(task.path) + " " + name_of(task.state) + " attempt " +
              std::to_string(task.attempt.value) + " " + task.message.substr(0, 80) + "\n";
    }
    for (const Worker& worker : workers_) {
      text += "worker " + std::to_string(worker.connection()) + " on " + worker.host() +
              " attempt " + std::to_string(worker.attempt().value) + " " + worker.report() + "\n";
    }
    return text;
  }

 private:
  struct Travelling {
    int connection = 0;
    bool is_up = false;  ///< to the coordinator
    ToCoordinator message;
  };

  static FarmRules rules_of(const Trouble& trouble) {
    FarmRules rules;
    rules.lease_ms = 1000;
    rules.max_crashes = trouble.is_strict ? 3 : 100000;
    rules.max_losses = trouble.is_strict ? 8 : 100000;
    rules.max_oom_count = trouble.is_strict ? 6 : 100000;
    rules.crash_delay_ms = 50;
    rules.loss_delay_ms = 10;
    rules.longest_delay_ms = 500;
    rules.elsewhere_ms = 300;
    rules.least_limit_ms = 4000;
    rules.unknown_limit_ms = 6000;
    rules.least_late_ms = 500;
    rules.keeps_all_files = [](const JobRow& job) { return job.job_toml == keeps_all_text; };
    return rules;
  }

  std::vector<Submission> submissions() const {
    std::vector<Submission> jobs;
    for (const ArtifactRef& job : wish_.jobs) {
      jobs.push_back({"key-" + std::to_string(jobs.size()), "wing",
                      jobs.empty() && wish_.first_keeps_all ? keeps_all_text : "",
                      to_inspect(job, surface())});
      // Of several jobs, the second remeshes its surface.
      jobs.back().remeshes = jobs.size() == 2;
      if (wish_.several_users) jobs.back().owner = "user-" + std::to_string(jobs.size());
    }
    return jobs;
  }

  Surroundings surroundings() {
    return {random_,
            trouble_,
            disk_,
            state().tasks,
            state().running_attempts,
            [this](const TaskRow& task) { return is_hopeless(wish_, task); },
            [this](const TaskRow& task) { return is_giant(wish_, task); },
            trouble_.has_bad_host ? "host-1" : "",
            now_ms_,
            [this](int connection, Message message) {
              note_result(connection, *message);
              post_up(connection, std::move(message));
            },
            [this] { return ++last_connection_; }};
  }

  Coordinator::Farm shared_with_coordinator() {
    return {
        random_,
        trouble_,
        disk_,
        invariants_,
        database_,
        jobs_,
        now_ms_,
        [this](int connection, Message message) { post(connection, false, std::move(message)); },
        [this](int connection) { return has_worker_at(connection); },
        wish_.second_waits};
  }

  bool has_worker_at(int connection) const {
    return std::any_of(workers_.begin(), workers_.end(), [connection](const Worker& worker) {
      return worker.connection() == connection;
    });
  }

  static ArtifactRef surface() { return fake_file("input_surface", "flange"); }

  // ---- time and trouble
  void go_to_the_next_event() {
    std::int64_t next = std::min(turn_ms_, clients_.wake_ms());
    if (!travelling_.empty()) next = std::min(next, travelling_.begin()->first);
    for (const Worker& worker : workers_) next = std::min(next, worker.wakes_ms());
    now_ms_ = std::max(now_ms_ + 1, next);
    surroundings_.now_ms = now_ms_;
  }

  void make_trouble() {
    if (random_.chance(trouble_.leap)) coordinator_.leap(3000);
    if (random_.chance(trouble_.wall_jump))
      coordinator_.set_wall_clock(random_.pick(200000) - 100000);
    if (random_.chance(trouble_.vanish)) disk_.lose_one(random_);
    if (random_.chance(trouble_.power)) lose_power(host_name(random_.pick(hosts)));
    if (random_.chance(trouble_.forgery)) forge();
    if (now_ms_ > first_ms + 15000) surroundings_.bad_host.clear();
    for (Worker& worker : workers_) {
      if (random_.chance(trouble_.stop)) worker.stop(now_ms_ + random_.pick(4000));
      if (random_.chance(trouble_.vacate)) worker.signal(surroundings_);
      if (random_.chance(trouble_.break_off)) {
        break_connection(worker.connection());
        worker.change_connection(++last_connection_);
      }
    }
    if (trouble_.death > 0) {
      std::erase_if(workers_, [this](const Worker&) { return random_.chance(trouble_.death); });
    }
  }

  Worker& any_worker() {
    return workers_[static_cast<std::size_t>(
        random_.pick(static_cast<std::int64_t>(workers_.size())))];
  }

  /// A copy of a process (restored from an image, say) claims its attempt, under a new nonce or on
  /// the connection of another, and has an empty result.
  void forge() {
    if (workers_.empty()) return;
    const Worker& victim = any_worker();
    const Worker& thief = any_worker();
    if (!victim.attempt() || &victim == &thief) return;
    WorkerInfo copy{.host = victim.host(), .nonce = "copy-" + std::to_string(++last_process_)};
    copy.memory_bytes = std::uint64_t{800} << 20U;
    invariants_.worker_starts(copy);
    const int connection = ++last_connection_;
    post_up(connection, message_of([&](wire::Envelope& envelope) {
              *envelope.mutable_hello() = hello_of(copy);
              envelope.mutable_hello()->set_running_task(victim.task().value);
              envelope.mutable_hello()->set_running_attempt(victim.attempt().value);
            }));
    for (const int from : {connection, thief.connection()}) {
      post_up(from, message_of([&](wire::Envelope& envelope) {
                envelope.mutable_done()->set_task(victim.task().value);
                envelope.mutable_done()->set_attempt(victim.attempt().value);
              }));
    }
  }

  static std::string host_name(std::int64_t number) { return "host-" + std::to_string(number); }

  void lose_power(const std::string& host) {
    std::erase_if(workers_, [&host](const Worker& worker) { return worker.host() == host; });
    disk_.lose_power(host);
  }

  void break_connection(int connection) {
    std::erase_if(travelling_, [connection](const auto& entry) {
      return entry.second.connection == connection;
    });
  }

  void replace_workers() {
    std::erase_if(workers_, [](const Worker& worker) { return worker.is_gone(); });
    while (workers_.size() < 3) start_worker();
  }

  void start_worker() {
    const std::int64_t host = random_.pick(hosts);
    WorkerInfo info;
    info.host = host_name(host);
    info.nonce = "process-" + std::to_string(++last_process_);
    info.shares_memory = random_.chance(0.7);
    info.memory_bytes = (info.shares_memory ? host_memory_mb[static_cast<std::size_t>(host)] : 800)
                        << 20U;
    if (random_.chance(trouble_.walltime)) info.ends_in_ms = 1000 + random_.pick(8000);
    invariants_.worker_starts(info);
    const bool sees_store = !random_.chance(trouble_.blind);
    workers_.emplace_back(info, sees_store, surroundings_);
  }

  // ---- the network
  void post_up(int connection, ToCoordinator message) {
    post(connection, true, std::move(message));
  }

  void post(int connection, bool is_up, ToCoordinator message) {
    if (random_.chance(trouble_.lost)) return;
    const int copies = random_.chance(trouble_.doubled) ? 2 : 1;
    for (int i = 0; i < copies; ++i) {
      const std::int64_t arrives_ms = now_ms_ + random_.pick(trouble_.latest_ms);
      travelling_.emplace(arrives_ms, Travelling{connection, is_up, message});
    }
  }

  void note_result(int connection, const wire::Envelope& message) {
    if (!message.has_done()) return;
    const AttemptId attempt{message.done().attempt()};
    for (const Worker& worker : workers_) {
      if (worker.connection() == connection) invariants_.result_said(attempt, worker.nonce());
    }
  }

  void deliver() {
    std::vector<Travelling> due;
    while (!travelling_.empty() && travelling_.begin()->first <= now_ms_) {
      due.push_back(std::move(travelling_.extract(travelling_.begin()).mapped()));
    }
    random_.shuffle(due);
    for (const Travelling& message : due) {
      if (message.is_up) {
        heard_ = true;
        coordinator_.receive(message.connection, message.message);
      } else {
        for (Worker& worker : workers_) {
          if (worker.connection() != message.connection) continue;
          worker.hear(std::get<Message>(message.message), surroundings_);
        }
      }
    }
  }

  static constexpr std::int64_t hosts = 3;
  static constexpr std::array<std::uint64_t, 3> host_memory_mb = {1000, 1500, 800};
  static constexpr std::int64_t first_ms = 1000000;
  static constexpr std::int64_t longest_turn_ms = 50;

  Random random_;
  Trouble trouble_;
  Wish wish_;
  Disk disk_;
  FarmDatabase database_;
  Invariants invariants_;
  std::int64_t now_ms_ = first_ms;
  std::int64_t turn_ms_ = 0;
  bool heard_ = false;
  int last_connection_ = 0;
  int last_process_ = 0;
  std::vector<Worker> workers_;
  std::multimap<std::int64_t, Travelling> travelling_;
  FarmRules rules_;
  std::vector<Submission> jobs_;
  Surroundings surroundings_;
  Coordinator coordinator_;
  Clients clients_;
};

}  // namespace tetfarm::simulation
