// Runs simulated farms, each from a seed that says what goes wrong and what is wanted, and compares
// their ends with that of an undisturbed farm.
#pragma once

#include <array>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <string>

#include "tests/coordinator/simulated_farm.h"

namespace tetfarm::simulation {

/// What must not depend on the course of events. The numbers of jobs do: of two submissions the one
/// that arrives first has the smaller one, so that jobs are listed by their keys.
inline std::string final_table(const DurableState& state) {
  std::map<std::string, std::string> lines;
  for (const auto& [id, task] : state.tasks) {
    if (task.state == TaskState::replaced) continue;
    std::string line;
    for (const ArtifactRef& file : task.outputs) line += " " + file.name + "=" + file.hash;
    const auto table = task.parameters.find("table");
    if (table != task.parameters.end()) line += "\n" + table->second;
    const std::string& key = state.jobs.at(task.job).key;
    lines[key + " " + name_of(task.kind) + " " + std::to_string(task.path)] = line;
  }
  std::map<std::string, JobPhase> key2phase;
  for (const auto& [id, job] : state.jobs) key2phase[job.key] = job.phase;
  std::string text;
  for (const auto& [key, phase] : key2phase) text += key + " " + name_of(phase) + "\n";
  for (const auto& [name, line] : lines) text += name + " " + line + "\n";
  return text;
}

inline Trouble trouble_of(std::uint64_t seed) {
  Random random(seed * 7919);
  const auto some = [&random](double most) {
    return random.chance(0.33) ? 0.0 : random.share() * most;
  };
  Trouble trouble;
  trouble.lost = some(0.3);
  trouble.doubled = some(0.3);
  trouble.latest_ms = 1 + static_cast<std::int64_t>(random.chance(0.5) ? some(100) : some(2000));
  trouble.break_off = some(0.002);
  trouble.death = some(0.003);
  trouble.stop = some(0.003);
  trouble.vacate = some(0.002);
  trouble.walltime = some(0.5);
  trouble.blind = some(0.5);
  trouble.absent = some(0.2);
  trouble.swept = some(0.2);
  trouble.power = some(0.003);
  trouble.crash = some(0.25);
  trouble.kill = some(0.25);
  trouble.hang = some(0.05);
  trouble.hungry = some(1);
  trouble.full_disk = some(0.2);
  trouble.no_process = some(0.05);
  trouble.bad_files = some(0.1);
  trouble.vanish = some(0.01);
  trouble.restart = some(0.01);
  trouble.blackout = some(1);
  trouble.commit_full = some(0.05);
  trouble.commit_busy = some(0.05);
  trouble.commit_broken = some(0.02);
  trouble.leap = some(0.003);
  trouble.wall_jump = some(0.01);
  trouble.forgery = some(0.01);
  trouble.whim = some(0.05);
  trouble.has_bad_host = random.chance(0.2);
  trouble.is_strict = random.chance(0.5);
  return trouble;
}

/// One or two jobs of 2 to 12 parts, some assimilated, some with layers, some with a sub-domain
/// that always fails, or with one that no worker has the memory for.
inline Wish wish_of(std::uint64_t seed) {
  Random random(seed * 104729);
  Wish wish;
  const std::uint64_t groups = random.chance(0.3) ? 3 : 0;
  const auto parts = static_cast<std::uint64_t>(groups > 0 ? 8 : 2 + random.pick(6));
  const auto chunks = static_cast<std::uint64_t>(random.chance(0.3) ? 1 + random.pick(3) : 0);
  wish.jobs.push_back(fake_job(random.chance(0.1) ? 12 : parts, groups, chunks));
  if (random.chance(0.15)) {
    wish.jobs.push_back(fake_job(2 + static_cast<std::uint64_t>(random.pick(5)), 0));
  }
  if (random.chance(0.1)) wish.hopeless = 4 + static_cast<std::uint64_t>(random.pick(4));
  if (random.chance(0.2)) {
    constexpr std::array kinds = {TaskKind::mesh, TaskKind::extract, TaskKind::cosmetic};
    wish.giant = 2 + static_cast<std::uint64_t>(random.pick(6));
    wish.giant_kind = kinds.at(static_cast<std::size_t>(random.pick(kinds.size())));
  }
  wish.first_keeps_all = random.chance(0.2);
  return wish;
}

/// At most so many steps of trouble; what is not over then must come to its end in calm ones.
inline void run_to_the_end(Farm& farm) {
  constexpr int wild_steps = 3000;
  constexpr int calm_steps = 200000;
  for (int i = 0; i < wild_steps; ++i) {
    if (farm.step() || testing::Test::HasFailure()) return;
  }
  farm.calm();
  for (int i = 0; i < calm_steps; ++i) {
    if (farm.step() || testing::Test::HasFailure()) return;
  }
  FAIL() << "the jobs do not come to an end\n" << farm.report();
}

/// A mistake of our own stops the process (base/check.h): even then the seed is told.
class SeedTeller {
 public:
  SeedTeller() { std::signal(SIGABRT, tell); }
  ~SeedTeller() { std::signal(SIGABRT, SIG_DFL); }
  SeedTeller(const SeedTeller&) = delete;
  SeedTeller& operator=(const SeedTeller&) = delete;
  void now_runs(std::uint64_t seed) {
    std::snprintf(text.data(), text.size(), "replay with TETFARM_SIMULATION_SEED=%llu\n",
                  static_cast<unsigned long long>(seed));
  }

 private:
  static void tell(int) { std::fputs(text.data(), stderr); }
  static inline std::array<char, 80> text{};
};

class Schedules {
 public:
  void run(std::uint64_t seed, bool has_real_database) {
    teller_.now_runs(seed);
    SCOPED_TRACE("replay with TETFARM_SIMULATION_SEED=" + std::to_string(seed));
    const Wish wish = wish_of(seed);
    const std::string& expected = undisturbed(wish);
    Farm farm(seed, trouble_of(seed), wish, has_real_database);
    run_to_the_end(farm);
    if (testing::Test::HasFailure()) {
      ADD_FAILURE() << farm.report();
      return;
    }
    EXPECT_EQ(final_table(farm.state()), expected);
    farm.invariants().all_accepted_once(farm.state());
    if (trouble_of(seed).vanish == 0) Invariants::none_made_again(farm.record());
  }

 private:
  const std::string& undisturbed(const Wish& wish) {
    std::string name = std::to_string(wish.hopeless) + " " + std::to_string(wish.giant) + " " +
                       name_of(wish.giant_kind);
    for (const ArtifactRef& job : wish.jobs) name += " " + job.hash;
    const auto known = tables_.find(name);
    if (known != tables_.end()) return known->second;
    Farm farm(1, Trouble{}, wish, false);
    run_to_the_end(farm);
    return tables_.emplace(name, final_table(farm.state())).first->second;
  }

  SeedTeller teller_;
  std::map<std::string, std::string> tables_;  // of farms where nothing went wrong
};

/// Stops at the first seed that fails. TETFARM_SIMULATION_SEED=N replays one;
/// TETFARM_SIMULATION_SEEDS=N runs so many.
inline void run_schedules(std::uint64_t first, std::uint64_t count, bool has_real_database) {
  const char* one = std::getenv("TETFARM_SIMULATION_SEED");
  const char* many = std::getenv("TETFARM_SIMULATION_SEEDS");
  if (many != nullptr) count = std::strtoull(many, nullptr, 10);
  if (one != nullptr) {
    first = std::strtoull(one, nullptr, 10);
    count = 1;
  }
  Schedules schedules;
  for (std::uint64_t seed = first; seed < first + count; ++seed) {
    schedules.run(seed, has_real_database);
    if (testing::Test::HasFailure()) return;
  }
}

}  // namespace tetfarm::simulation
