#include <gtest/gtest.h>

#include "tests/coordinator/simulated_farm.h"

namespace tetfarm {
namespace {

TEST(JobStateSimulation, every_schedule_ends_with_the_same_table_and_each_task_accepted_once) {
  simulation::expect_the_same_end(1, 200);
}

}  // namespace
}  // namespace tetfarm
