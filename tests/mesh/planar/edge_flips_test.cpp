#include "mesh/planar/edge_flips.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tetfarm {
namespace {

using ::testing::IsEmpty;

/// A flat kite whose long diagonal 0-2 is not Delaunay.
TriangleComplex kite() {
  return make_triangle_complex({{-2, 0}, {0, -1}, {2, 0}, {0, 1}}, {{0, 1, 2}, {0, 2, 3}});
}

TEST(EdgeFlips, swaps_a_diagonal_that_is_not_delaunay) {
  TriangleComplex complex = kite();
  EXPECT_FALSE(is_locally_delaunay(complex, complex.find_edge(0, 2)));
  EXPECT_EQ(flip_to_delaunay(complex), 1U);
  EXPECT_NE(complex.find_edge(1, 3), no_edge);
  EXPECT_THAT(validate(complex), IsEmpty());
}

TEST(EdgeFlips, leaves_a_constrained_edge) {
  TriangleComplex complex = kite();
  complex.constrain(complex.find_edge(0, 2), true);
  EXPECT_EQ(flip_to_delaunay(complex), 0U);
}

TEST(EdgeFlips, leaves_cocircular_points) {
  TriangleComplex complex =
      make_triangle_complex({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {{0, 1, 2}, {0, 2, 3}});
  EXPECT_EQ(flip_to_delaunay(complex), 0U);
}

TEST(EdgeFlips, mends_a_long_fan) {
  // All triangles of a convex chain from one corner: far from Delaunay.
  std::vector<Vec2> points;
  for (int i = 0; i <= 40; ++i) points.push_back({i - 20.0, 0.05 * (i - 20) * (i - 20)});
  std::vector<TriangleComplex::Nodes> triangles;
  for (std::int32_t i = 1; i < 40; ++i) triangles.push_back({0, i, i + 1});
  TriangleComplex complex = make_triangle_complex(points, triangles);
  EXPECT_GT(flip_to_delaunay(complex), 30U);
  EXPECT_THAT(validate(complex), IsEmpty());
  for (std::int32_t t = 0; t < complex.size(); ++t)
    for (int i = 0; i < 3; ++i) EXPECT_TRUE(is_locally_delaunay(complex, edge_handle(t, i)));
}

}  // namespace
}  // namespace tetfarm
