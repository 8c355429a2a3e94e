#include "mesh/recovery/surface_flats.h"

#include <gtest/gtest.h>

#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

/// A square of two triangles (0 1 2, 0 2 3), and one more at a right angle on its edge 01.
SurfaceFlats square_and_wall() {
  const std::vector<Vec3> points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}};
  return SurfaceFlats(points, {{0, 1, 2}, {0, 2, 3}, {1, 0, 4}});
}

TEST(SurfaceFlats, of_neighbours_in_one_plane_are_one) {
  SurfaceFlats flats = square_and_wall();
  EXPECT_TRUE(flats.are_flat({0, 1, 2, 3}));
  EXPECT_FALSE(flats.are_flat({0, 1, 2, 4}));
  flats.add(5, std::array{0, 2, 3});
  EXPECT_TRUE(flats.are_flat({5, 1, 2, 3}));
  EXPECT_FALSE(flats.are_flat({5, 1, 2, 4}));
}

TEST(SurfaceFlats, hold_three_points_of_an_edge_in_line_with_any_fourth) {
  SurfaceFlats flats = square_and_wall();
  flats.add(5, std::array{0, 1});
  flats.add(6, std::array{5, 1});
  for (const std::int32_t any : {2, 3, 4}) {
    EXPECT_TRUE(flats.are_flat({0, any, 5, 1}));
    EXPECT_TRUE(flats.are_flat({any, 5, 6, 0}));
  }
  EXPECT_TRUE(flats.are_in_line({1, 6, 0}));
  EXPECT_FALSE(flats.are_in_line({1, 2, 0}));
  EXPECT_TRUE(flats.are_flat({5, 6, 2, 3}));
  EXPECT_FALSE(flats.are_flat({5, 6, 2, 4}));
  flats.add(7, std::array{5, 2});
  EXPECT_FALSE(flats.are_flat({7, 5, 1, 4}));
  EXPECT_TRUE(flats.are_flat({7, 5, 2, 4}));
}

TEST(SurfaceFlats, forget_a_point_that_has_left) {
  SurfaceFlats flats = square_and_wall();
  flats.add(5, std::array{0, 1});
  flats.remove(5);
  EXPECT_FALSE(flats.are_flat({0, 5, 1, 2}));
  EXPECT_FALSE(flats.are_flat({0, 100, 1, 2}));
}

}  // namespace
}  // namespace tetfarm
