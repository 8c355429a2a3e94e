#include <gtest/gtest.h>

#include "tests/coordinator/farm_schedules.h"

namespace tetfarm {
namespace {

// `./dev test schedules` runs a hundred thousand of them.
TEST(SimulatedFarm, many_schedules_end_as_an_undisturbed_farm) {
  simulation::run_schedules(100'000, 12'000, false);
}

TEST(SimulatedFarm, a_thousand_schedules_with_the_real_database_on_a_disk_that_fails) {
  simulation::run_schedules(2'000'000, 1000, true);
}

}  // namespace
}  // namespace tetfarm
