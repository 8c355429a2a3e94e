#include <gtest/gtest.h>

#include "tests/coordinator/farm_schedules.h"

namespace tetfarm {
namespace {

TEST(SimulatedFarm, whatever_fails_the_invariants_hold_and_the_end_is_that_of_an_undisturbed_farm) {
  simulation::run_schedules(1, 2000, false);
}

TEST(SimulatedFarm, the_same_holds_with_the_real_database_on_a_disk_that_fails) {
  simulation::run_schedules(1'000'001, 60, true);
}

}  // namespace
}  // namespace tetfarm
