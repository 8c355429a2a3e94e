#include "mesh/decompose/face_colouring.h"

#include <gtest/gtest.h>

#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

TEST(FaceColouring, is_left_below_the_plane_and_right_from_it_on) {
  SurfaceTopology topology;
  topology.centroid = {{0, 0, -0.25}, {0, 0, 0}, {0, 0, 0.25}, {9, 9, 0.49}, {0, 0, 0.5}};
  const FaceColours colours = colour_by_centroid(topology, make_cut_plane({0, 0, 1}, 0.25));
  EXPECT_EQ(colours, (FaceColours{Side::left, Side::left, Side::right, Side::right, Side::right}));
}

TEST(FaceColouring, has_two_sides_each_the_other_of_the_other) {
  EXPECT_EQ(other(Side::left), Side::right);
  EXPECT_EQ(other(Side::right), Side::left);
}

TEST(FaceColouring, counts_the_edges_to_triangles_of_the_other_colour) {
  // Every triangle of a tetrahedron has an edge with each of the others.
  const SurfaceTopology topology = make_surface_topology(root_subdomain(shapes::tetrahedron()));
  FaceColours colours(4, Side::left);
  for (std::int32_t t = 0; t < 4; ++t) EXPECT_EQ(edges_between_colours(colours, topology, t), 0);
  colours[1] = Side::right;
  EXPECT_EQ(edges_between_colours(colours, topology, 0), 1);
  EXPECT_EQ(edges_between_colours(colours, topology, 1), 3);
  colours[2] = Side::right;
  for (std::int32_t t = 0; t < 4; ++t) EXPECT_EQ(edges_between_colours(colours, topology, t), 2);
}

}  // namespace
}  // namespace tetfarm
