#include "mesh/half_body/nested_loops.h"

#include <gmock/gmock.h>

#include <algorithm>

namespace tetfarm {
namespace {

using testing::ElementsAre;

std::vector<Vec2> square_round(double x, double y, double half) {
  return {{x - half, y - half}, {x + half, y - half}, {x + half, y + half}, {x - half, y + half}};
}

std::vector<Vec2> turned(std::vector<Vec2> loop) {
  std::reverse(loop.begin(), loop.end());
  return loop;
}

TEST(NestedLoops, run_so_that_the_region_is_on_their_left) {
  const std::vector<std::vector<Vec2>> loops = {square_round(0, 0, 4), square_round(-1, 0, 2),
                                                square_round(-1, 0, 1), square_round(3, 3, 0.5)};
  EXPECT_THAT(turned_loops(loops), ElementsAre(false, true, false, true));
  std::vector<std::vector<Vec2>> others;
  for (const std::vector<Vec2>& loop : loops) others.push_back(turned(loop));
  EXPECT_THAT(turned_loops(others), ElementsAre(true, false, true, false));
}

TEST(NestedLoops, that_lie_beside_each_other_are_all_outer_ones) {
  EXPECT_THAT(turned_loops({square_round(0, 0, 1), turned(square_round(3, 0, 1))}),
              ElementsAre(false, true));
}

TEST(NestedLoops, are_told_apart_at_the_height_of_their_vertices) {
  // The leftmost point of the inner loop is as high as a corner of the outer one.
  const std::vector<Vec2> diamond = {{-2, 0}, {0, -2}, {2, 0}, {0, 2}};
  const std::vector<Vec2> inner = {{-1, 0}, {0, -1}, {1, 0}, {0, 1}};
  const std::vector<Vec2> beside = {{-4, 0}, {-3.5, -1}, {-3, 0}, {-3.5, 1}};
  EXPECT_THAT(turned_loops({diamond, inner, beside}), ElementsAre(false, true, false));
}

TEST(NestedLoops, have_twice_the_area_that_their_sign_says) {
  EXPECT_EQ(twice_area(square_round(1, 1, 1)), 8);
  EXPECT_EQ(twice_area(turned(square_round(1, 1, 1))), -8);
}

}  // namespace
}  // namespace tetfarm
