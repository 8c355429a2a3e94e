#include "mesh/decompose/surface_topology.h"

#include <gtest/gtest.h>

#include "base/array_index.h"
#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

void expect_twins_match(const Subdomain& subdomain, const SurfaceTopology& topology) {
  for (HalfEdge h = 0; h < static_cast<HalfEdge>(topology.twin.size()); ++h) {
    const HalfEdge twin = topology.twin[at(h)];
    EXPECT_EQ(topology.twin[at(twin)], h);
    EXPECT_EQ(start_of(subdomain.triangles, h), end_of(subdomain.triangles, twin));
    EXPECT_EQ(end_of(subdomain.triangles, h), start_of(subdomain.triangles, twin));
  }
}

TEST(SurfaceTopology, twins_are_the_same_edge_the_other_way) {
  const Subdomain torus = root_subdomain(shapes::torus(0.3, 12, 7));
  expect_twins_match(torus, make_surface_topology(torus));
}

TEST(SurfaceTopology, pairs_the_four_triangles_of_an_edge_where_boxes_touch) {
  SurfaceMesh two = shapes::tetrahedron();
  // A second tetrahedron below the edge 0-1, sharing just that edge.
  two.vertices.push_back({0, -1, 0});
  two.vertices.push_back({0, 0, -1});
  two.triangles.insert(two.triangles.end(), {{0, 4, 1}, {0, 1, 5}, {0, 5, 4}, {1, 4, 5}});
  const Subdomain touching = root_subdomain(two);
  expect_twins_match(touching, make_surface_topology(touching));
}

TEST(SurfaceTopology, tells_shells_apart) {
  const SurfaceTopology topology = make_surface_topology(root_subdomain(shapes::nested_spheres(1)));
  EXPECT_EQ(topology.triangle2shell.front(), 0);
  EXPECT_EQ(topology.triangle2shell.back(), 1);
  EXPECT_EQ(topology.triangle2shell[79], 0);
  EXPECT_EQ(topology.triangle2shell[80], 1);
}

TEST(SurfaceTopology, goes_once_round_a_vertex) {
  const Subdomain sphere = root_subdomain(shapes::sphere({0, 0, 0}, 1, 0));
  const SurfaceTopology topology = make_surface_topology(sphere);
  for (const HalfEdge h : topology.vertex2half_edge) {
    const auto round = half_edges_round_start(topology, h);
    EXPECT_EQ(round.size(), 5U);
    for (const HalfEdge g : round) {
      EXPECT_EQ(start_of(sphere.triangles, g), start_of(sphere.triangles, h));
    }
  }
}

}  // namespace
}  // namespace tetfarm
