#include "mesh/decompose/path_relaxation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

struct Coloured {
  Coloured(const SurfaceMesh& surface, const CutPlane& cut_plane)
      : subdomain(root_subdomain(surface)),
        topology(make_surface_topology(subdomain)),
        plane(cut_plane),
        colours(colour_by_centroid(topology, plane)) {}

  /// Of the edges between colours.
  double path_length() const {
    double sum = 0;
    for (HalfEdge h = 0; h < std::ssize(topology.twin); ++h) {
      if (colours[at(triangle_of(h))] != Side::left) continue;
      if (colours[at(triangle_of(topology.twin[at(h)]))] != Side::right) continue;
      sum += distance(subdomain.vertices[at(start_of(subdomain.triangles, h))],
                      subdomain.vertices[at(end_of(subdomain.triangles, h))]);
    }
    return sum;
  }
  /// Of the triangle's centroid, in its size.
  double height(std::size_t t) const {
    return plane.height(topology.centroid[t]) / topology.size[t];
  }

  Subdomain subdomain;
  SurfaceTopology topology;
  CutPlane plane;
  FaceColours colours;
};

TEST(PathRelaxation, makes_the_path_shorter_than_the_colours_of_centroids_do) {
  Coloured ball(shapes::sphere({0, 0, 0}, 1, 3), make_cut_plane(normalized(Vec3{1, 2, 3}), 0.3));
  const double before = ball.path_length();
  relax_path(ball.colours, ball.subdomain, ball.topology, ball.plane);
  EXPECT_LT(ball.path_length(), 0.9 * before);
  // Round the circle in which the plane meets the sphere.
  EXPECT_GT(ball.path_length(), 2 * 3.14 * std::sqrt(1 - 0.09));
}

TEST(PathRelaxation, changes_nothing_farther_from_the_plane_than_three_quarters_of_a_triangle) {
  Coloured ball(shapes::sphere({0, 0, 0}, 1, 3), make_cut_plane(normalized(Vec3{1, 2, 3}), 0.3));
  const FaceColours before = ball.colours;
  relax_path(ball.colours, ball.subdomain, ball.topology, ball.plane);
  double farthest = 0;
  for (std::size_t t = 0; t < before.size(); ++t) {
    if (ball.colours[t] == before[t]) continue;
    farthest = std::max(farthest, std::fabs(ball.height(t)));
  }
  EXPECT_LE(farthest, 0.75);
  EXPECT_GT(farthest, 0.1) << "something has changed";
}

TEST(PathRelaxation, of_a_box_runs_along_the_row_of_edges_that_is_nearest_to_the_plane) {
  // Rows at 0, 0.25, 0.5, ...: the plane lies a little above that of 0.5.
  Coloured box(shapes::box({0, 0, 0}, {1, 1, 1}, 4), make_cut_plane({0, 0, 1}, 0.54));
  relax_path(box.colours, box.subdomain, box.topology, box.plane);
  EXPECT_EQ(box.path_length(), 4);
  for (std::size_t t = 0; t < box.colours.size(); ++t) {
    EXPECT_EQ(box.colours[t], box.topology.centroid[t].z < 0.5 ? Side::left : Side::right);
  }
}

/// Up to where a box of rows at 0, 0.25, 0.5, ... is left of a level plane at that height.
double top_of_left(double offset) {
  Coloured box(shapes::box({0, 0, 0}, {1, 1, 1}, 4), make_cut_plane({0, 0, 1}, offset));
  relax_path(box.colours, box.subdomain, box.topology, box.plane);
  double highest = 0;
  for (std::size_t t = 0; t < box.colours.size(); ++t) {
    if (box.colours[t] != Side::left) continue;
    for (const std::int32_t v : box.subdomain.triangles[t]) {
      highest = std::max(highest, box.subdomain.vertices[at(v)].z);
    }
  }
  return highest;
}

TEST(PathRelaxation, goes_to_the_nearer_of_two_rows) {
  EXPECT_EQ(top_of_left(0.65), 0.75);
  EXPECT_EQ(top_of_left(0.6), 0.5);
  EXPECT_EQ(top_of_left(0.36), 0.25);
  EXPECT_EQ(top_of_left(0.39), 0.5);
}

TEST(PathRelaxation, vanishes_where_all_that_lies_beyond_the_plane_is_near_to_it) {
  // The whole top lies within the band, so that nothing has to stay right.
  EXPECT_EQ(top_of_left(0.9), 1);
}

}  // namespace
}  // namespace tetfarm
