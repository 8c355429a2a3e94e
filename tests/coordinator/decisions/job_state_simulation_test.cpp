#include <gtest/gtest.h>

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
