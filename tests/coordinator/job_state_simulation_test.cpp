#include <gtest/gtest.h>

#include "tests/coordinator/simulated_farm.h"

namespace tetfarm {
namespace {

TEST(JobStateSimulation, every_schedule_ends_with_the_same_table_and_each_task_accepted_once) {
  simulation::expect_the_same_end(1, 200, make_believe_job(12, 0));
}

TEST(JobStateSimulation, the_same_holds_when_leaves_are_assimilated) {
  simulation::expect_the_same_end(1, 200, make_believe_job(12, 3));
}

}  // namespace
}  // namespace tetfarm
