#include "tasks/task_place.h"

#include <gtest/gtest.h>

namespace tetfarm {
namespace {

TEST(TaskPlace, is_a_sub_domain_by_its_way_in_the_tree_or_a_cycle_by_its_number) {
  EXPECT_EQ(task_place("mesh", 5), "LR");
  EXPECT_EQ(task_place("solve", 5), "cycle 5");
  EXPECT_EQ(task_place("adapt", 1), "cycle 1");
  EXPECT_EQ(task_place("inspect", 0), "");
  EXPECT_EQ(of_task_place("mesh", 5), " of sub-domain LR");
  EXPECT_EQ(of_task_place("mesh", 1), " of the whole domain");
  EXPECT_EQ(of_task_place("solve", 1), " of cycle 1");
  EXPECT_EQ(of_task_place("collect", 0), "");
  EXPECT_TRUE(is_place_in_tree("mesh", 1));
  EXPECT_FALSE(is_place_in_tree("mesh", 0));
  EXPECT_FALSE(is_place_in_tree("solve", 1));
}

TEST(TaskPlace, of_a_kind_that_is_not_known_is_a_sub_domain) {
  EXPECT_EQ(of_task_place("polish", 4), " of sub-domain LL");
}

}  // namespace
}  // namespace tetfarm
