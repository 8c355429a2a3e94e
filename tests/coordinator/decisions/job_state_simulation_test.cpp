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
