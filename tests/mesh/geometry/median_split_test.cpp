#include "mesh/geometry/median_split.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace tetfarm {
namespace {

TEST(MedianSplit, puts_the_lower_half_first_and_ties_by_number) {
  std::vector<Box3> boxes;
  for (const double y : {5.0, 1.0, 3.0, 3.0, 3.0}) boxes.push_back({{0, y, 0}, {1, y + 1, 1}});
  std::vector<std::int32_t> items = {4, 3, 2, 1, 0};
  ASSERT_EQ(split_at_median(items, boxes, 1), 2U);
  std::sort(items.begin(), items.begin() + 2);
  std::sort(items.begin() + 2, items.end());
  EXPECT_THAT(items, testing::ElementsAre(1, 2, 0, 3, 4));
}

}  // namespace
}  // namespace tetfarm
