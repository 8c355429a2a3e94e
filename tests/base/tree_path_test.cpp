#include "base/tree_path.h"

#include <gtest/gtest.h>

namespace tetfarm {
namespace {

TEST(TreeWay, goes_left_and_right_from_the_root) {
  EXPECT_EQ(tree_path(1), "root");
  EXPECT_EQ(tree_path(2), "L");
  EXPECT_EQ(tree_path(3), "R");
  EXPECT_EQ(tree_path(5), "LR");
  EXPECT_EQ(tree_path(6), "RL");
  EXPECT_EQ(tree_path(std::uint64_t{1} << 63U), std::string(63, 'L'));
}

}  // namespace
}  // namespace tetfarm
