#include "mesh/adaptation/curve_tracing.h"

#include <gtest/gtest.h>

#include "tests/mesh/adaptation/plane_shapes.h"

namespace tetfarm {
namespace {

TracedBoundary traced(const PlaneMesh& mesh, double angle = 30) {
  TriangleComplex complex = checked_complex(mesh);
  return trace_boundary(mesh, hold_edges(mesh, complex), angle);
}

TEST(CurveTracing, goes_from_corner_to_corner) {
  const TracedBoundary boundary = traced(plane_test::square(3));
  EXPECT_EQ(boundary.corners.size(), 4U);
  ASSERT_EQ(boundary.pieces.size(), 4U);
  for (const BoundaryPiece& piece : boundary.pieces) {
    EXPECT_EQ(piece.nodes.size(), 4U);
    EXPECT_FALSE(piece.is_closed);
  }
}

TEST(CurveTracing, closes_a_loop_without_corners) {
  const TracedBoundary boundary = traced(plane_test::disc(4));
  EXPECT_TRUE(boundary.corners.empty());
  ASSERT_EQ(boundary.pieces.size(), 1U);
  EXPECT_TRUE(boundary.pieces[0].is_closed);
  EXPECT_EQ(boundary.pieces[0].nodes.size(), 24U);
}

TEST(CurveTracing, begins_and_ends_a_loop_at_its_one_corner) {
  PlaneMesh disc = plane_test::disc(4);
  disc.corners = {disc.edges[0][0]};
  const TracedBoundary boundary = traced(disc);
  EXPECT_EQ(boundary.corners, disc.corners);
  ASSERT_EQ(boundary.pieces.size(), 1U);
  EXPECT_EQ(boundary.pieces[0].nodes.size(), 25U);
  EXPECT_EQ(boundary.pieces[0].nodes.front(), disc.corners[0]);
  EXPECT_EQ(boundary.pieces[0].nodes.back(), disc.corners[0]);
}

TEST(CurveTracing, holds_the_edges_between_regions_as_patch_0) {
  PlaneMesh mesh = plane_test::two_regions(4);
  TriangleComplex complex = checked_complex(mesh);
  int between = 0;
  for (const HeldEdge& edge : hold_edges(mesh, complex)) between += edge.patch == 0 ? 1 : 0;
  EXPECT_EQ(between, 4);
}

}  // namespace
}  // namespace tetfarm
