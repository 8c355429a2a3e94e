#include "mesh/geometry/box_measures.h"

#include <gtest/gtest.h>

namespace tetfarm {
namespace {

TEST(BoxMeasures, longest_axis_is_the_first_of_those_equally_long) {
  EXPECT_EQ(longest_axis({{0, 0, 0}, {3, 2, 1}}), 0);
  EXPECT_EQ(longest_axis({{0, 0, 0}, {1, 3, 2}}), 1);
  EXPECT_EQ(longest_axis({{5, 5, 5}, {6, 7, 8}}), 2);
  EXPECT_EQ(longest_axis({{0, 0, 0}, {2, 2, 2}}), 0);
  EXPECT_EQ(longest_axis({{0, 0, 0}, {1, 2, 2}}), 1);
}

TEST(BoxMeasures, distance_to_a_box_is_that_to_its_nearest_side_edge_or_corner) {
  const Box3 box{{0, 0, 0}, {1, 2, 3}};
  EXPECT_EQ(distance2_to_box(box, {0.5, 1, 1}), 0);
  EXPECT_EQ(distance2_to_box(box, {1, 2, 3}), 0);
  EXPECT_EQ(distance2_to_box(box, {0.5, 1, 5}), 4);
  EXPECT_EQ(distance2_to_box(box, {-3, 6, 1}), 25);
  EXPECT_EQ(distance2_to_box(box, {2, 4, 5}), 9);
}

}  // namespace
}  // namespace tetfarm
