#include "mesh/decompose/edge_loops.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>

#include "base/array_index.h"
#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

struct Coloured {
  Coloured(const SurfaceMesh& surface, const CutPlane& plane)
      : subdomain(root_subdomain(surface)),
        topology(make_surface_topology(subdomain)),
        colours(colour_by_centroid(topology, plane)) {}
  EdgeLoops loops() const { return find_edge_loops(colours, topology, subdomain.triangles); }

  Subdomain subdomain;
  SurfaceTopology topology;
  FaceColours colours;
};

bool has_edge(const Triangle& t, std::int32_t from, std::int32_t to) {
  return (t[0] == from && t[1] == to) || (t[1] == from && t[2] == to) ||
         (t[2] == from && t[0] == to);
}

/// They close, pass each edge between colours once, and have left and right where they say.
void expect_loops(const Coloured& coloured, std::size_t count) {
  const EdgeLoops found = coloured.loops();
  EXPECT_TRUE(found.pinched_nodes.empty());
  ASSERT_EQ(found.loops.size(), count);
  std::set<std::array<std::int32_t, 2>> edges;
  for (const std::vector<RimEdge>& loop : found.loops) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const RimEdge& edge = loop[i];
      EXPECT_EQ(edge.to, loop[(i + 1) % loop.size()].from);
      EXPECT_TRUE(edges.insert({edge.from, edge.to}).second);
      EXPECT_EQ(coloured.colours[at(edge.left_triangle)], Side::left);
      EXPECT_EQ(coloured.colours[at(edge.right_triangle)], Side::right);
      const std::vector<Triangle>& triangles = coloured.subdomain.triangles;
      EXPECT_TRUE(has_edge(triangles[at(edge.left_triangle)], edge.to, edge.from));
      EXPECT_TRUE(has_edge(triangles[at(edge.right_triangle)], edge.from, edge.to));
    }
  }
  std::size_t between_colours = 0;
  for (std::int32_t t = 0; t < std::ssize(coloured.subdomain.triangles); ++t) {
    if (coloured.colours[at(t)] != Side::left) continue;
    between_colours += at(edges_between_colours(coloured.colours, coloured.topology, t));
  }
  EXPECT_EQ(edges.size(), between_colours);
  const auto first_of = [](const std::vector<RimEdge>& loop) {
    return std::min_element(
               loop.begin(), loop.end(),
               [](const RimEdge& a, const RimEdge& b) { return a.left_triangle < b.left_triangle; })
        ->left_triangle;
  };
  EXPECT_TRUE(
      std::is_sorted(found.loops.begin(), found.loops.end(),
                     [&](const auto& a, const auto& b) { return first_of(a) < first_of(b); }));
}

TEST(EdgeLoops, of_a_sphere_are_one_and_of_what_a_plane_meets_more_often_as_many) {
  expect_loops({shapes::sphere({0, 0, 0}, 1, 3), make_cut_plane(normalized(Vec3{1, 2, 3}), 0.2)},
               1);
  expect_loops({shapes::torus(0.3, 24, 12), make_cut_plane({1, 0, 0}, 0.03)}, 2);
  expect_loops({shapes::nested_spheres(3), make_cut_plane({0, 0, 1}, 0.1)}, 2);
  expect_loops({shapes::nested_spheres(3), make_cut_plane({0, 0, 1}, 0.7)}, 1);
}

TEST(EdgeLoops, of_one_colour_are_none) {
  expect_loops({shapes::unit_cube(), make_cut_plane({0, 0, 1}, 5)}, 0);
  expect_loops({shapes::unit_cube(), make_cut_plane({0, 0, 1}, -5)}, 0);
}

TEST(EdgeLoops, that_meet_in_a_node_are_pinched_there) {
  Coloured coloured(shapes::sphere({0, 0, 0}, 1, 2), make_cut_plane({0, 0, 1}, -5));
  // Of the triangles round a vertex two that have no edge in common.
  const HalfEdge start = coloured.topology.vertex2half_edge[30];
  const std::vector<HalfEdge> round = half_edges_round_start(coloured.topology, start);
  ASSERT_GE(round.size(), 4U);
  coloured.colours[at(triangle_of(round[0]))] = Side::left;
  expect_loops(coloured, 1);
  coloured.colours[at(triangle_of(round[2]))] = Side::left;
  const EdgeLoops found = coloured.loops();
  EXPECT_TRUE(found.loops.empty());
  EXPECT_EQ(found.pinched_nodes, std::vector<std::int32_t>{30});
}

}  // namespace
}  // namespace tetfarm
