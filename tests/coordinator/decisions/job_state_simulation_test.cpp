#include <gtest/gtest.h>

#include <set>
#include <string>

#include "base/sanitizers.h"
#include "tests/coordinator/farm_schedules.h"

namespace tetfarm {
namespace {

// Under a sanitizer one takes a third of a second.
constexpr std::uint64_t schedules = is_sanitized ? 200 : 2000;

TEST(SimulatedFarm, whatever_fails_the_invariants_hold_and_the_end_is_that_of_an_undisturbed_farm) {
  simulation::run_schedules(1, schedules, false);
}

TEST(SimulatedFarm, the_same_holds_with_the_real_database_on_a_disk_that_fails) {
  simulation::run_schedules(1'000'001, 60, true);
}

TEST(SimulatedFarm, without_trouble_nothing_stays_but_results_and_what_a_job_begins_with) {
  simulation::Wish wish;
  wish.jobs = {fake_job(7, 0, 2)};
  simulation::Farm farm(1, simulation::Trouble{}, wish, false);
  simulation::run_to_the_end(farm);
  farm.remove_the_rest();
  std::set<std::string> stay;
  for (const auto& [id, task] : farm.state().tasks) {
    const TaskKindTraits& traits = traits_of(task.kind);
    for (const ArtifactRef& file : task.inputs) {
      if (traits.begins_job) stay.insert(file.hash);
    }
    for (const ArtifactRef& file : task.outputs) {
      if (traits.begins_job || traits.ends_job) stay.insert(file.hash);
    }
  }
  EXPECT_EQ(farm.disk().hashes(), stay);
  EXPECT_GT(farm.invariants().removed(), 20U);
}

/// Whether tasks of a job were handed out only when all that it waits for had been done.
void expect_waited(const simulation::Farm& farm) {
  std::set<JobId> done;
  for (const EventRow& event : farm.record().events()) {
    if (event.what == "job done") done.insert(event.job);
    if (event.what != "assigned") continue;
    for (const JobId other : farm.state().jobs.at(event.job).after) {
      EXPECT_TRUE(done.contains(other)) << "task " << event.task.value;
    }
  }
}

TEST(SimulatedFarm, a_job_that_waits_begins_when_the_other_is_done_whatever_fails) {
  simulation::Wish wish;
  wish.jobs = {fake_job(4, 0), fake_job(5, 0)};
  wish.second_waits = true;
  wish.several_users = true;
  simulation::Farm undisturbed(1, simulation::Trouble{}, wish, false);
  simulation::run_to_the_end(undisturbed);
  expect_waited(undisturbed);
  const std::string expected = simulation::final_table(undisturbed.state());
  for (std::uint64_t seed = 1; seed <= schedules / 10 && !HasFailure(); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    simulation::Farm farm(seed, simulation::trouble_of(seed), wish, seed % 50 == 0);
    simulation::run_to_the_end(farm);
    EXPECT_EQ(simulation::final_table(farm.state()), expected);
    expect_waited(farm);
  }
}

TEST(SimulatedFarm, of_two_users_no_one_changes_what_comes_out) {
  simulation::Wish wish;
  wish.jobs = {fake_job(4, 0), fake_job(5, 0)};
  simulation::Farm of_one(1, simulation::Trouble{}, wish, false);
  simulation::run_to_the_end(of_one);
  wish.several_users = true;
  for (std::uint64_t seed = 1; seed <= schedules / 20 && !HasFailure(); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    simulation::Farm farm(seed, simulation::trouble_of(seed), wish, false);
    simulation::run_to_the_end(farm);
    EXPECT_EQ(simulation::final_table(farm.state()), simulation::final_table(of_one.state()));
  }
}

TEST(SimulatedFarm, of_two_jobs_the_second_may_arrive_first) {
  simulation::run_schedules(119'879, 1, false);
}

TEST(SimulatedFarm, its_end_is_told_alike_whichever_job_arrived_first) {
  const auto told = [](const std::string& first, const std::string& second) {
    DurableState state;
    state.jobs[JobId{1}].key = first;
    state.jobs[JobId{2}].key = second;
    return simulation::final_table(state);
  };
  EXPECT_EQ(told("wing", "flange"), told("flange", "wing"));
  EXPECT_NE(told("wing", "flange"), told("wing", "tail"));
}

}  // namespace
}  // namespace tetfarm
