#include <gtest/gtest.h>

#include <cstdlib>

#include "tests/coordinator/simulated_farm.h"

namespace tetfarm {
namespace {

std::uint64_t from_environment(const char* name, std::uint64_t otherwise) {
  const char* text = std::getenv(name);
  return text != nullptr ? std::strtoull(text, nullptr, 10) : otherwise;
}

// TETFARM_SIMULATION_SEEDS sets how many; TETFARM_SIMULATION_FIRST_SEED which is the first.
TEST(JobStateSimulation, thousands_of_schedules_end_with_the_same_table) {
  simulation::expect_the_same_end(from_environment("TETFARM_SIMULATION_FIRST_SEED", 1000),
                                  from_environment("TETFARM_SIMULATION_SEEDS", 3000),
                                  make_believe_job(12, 0));
}

TEST(JobStateSimulation, thousands_of_schedules_with_assimilation_end_with_the_same_table) {
  simulation::expect_the_same_end(from_environment("TETFARM_SIMULATION_FIRST_SEED", 1000),
                                  from_environment("TETFARM_SIMULATION_SEEDS", 3000),
                                  make_believe_job(12, 3));
}

}  // namespace
}  // namespace tetfarm
