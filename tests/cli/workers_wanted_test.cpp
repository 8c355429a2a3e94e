#include "cli/workers_wanted.h"

#include <gtest/gtest.h>

namespace tetfarm {
namespace {

TEST(WorkersWanted, are_as_many_as_tasks_run_and_wait) {
  wire::StatusReply farm;
  EXPECT_EQ(workers_wanted(farm), 0U);
  for (const std::uint64_t task : {7, 0, 3}) farm.add_at_work()->set_task(task);
  EXPECT_EQ(workers_wanted(farm), 2U) << "one has no task";
  farm.add_demand()->set_tasks(5);
  farm.add_demand()->set_tasks(10);
  EXPECT_EQ(workers_wanted(farm), 17U);
}

}  // namespace
}  // namespace tetfarm
