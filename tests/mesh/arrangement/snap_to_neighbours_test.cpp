#include "mesh/arrangement/snap_to_neighbours.h"

#include <gmock/gmock.h>

#include <algorithm>

namespace tetfarm {
namespace {

using ::testing::SizeIs;

constexpr double reach = 1e-3;
constexpr double little = 1e-4;

TriangleChain two_triangles(const TrianglePoints& a, const TrianglePoints& b) {
  TriangleChain chain;
  chain.vertices.assign(a.begin(), a.end());
  chain.vertices.insert(chain.vertices.end(), b.begin(), b.end());
  chain.triangles = {{{0, 1, 2}, 1, 0, false, true}, {{3, 4, 5}, 1, 1, false, true}};
  return chain;
}

const TrianglePoints flat = {{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}};

TEST(SnapToNeighbours, vertices_that_nearly_are_one_become_the_first) {
  TriangleChain chain = two_triangles(flat, {{{4, little, 0}, {5, 5, 1}, {5, 5, -1}}});
  EXPECT_EQ(join_near_vertices(chain, {{0, 1}}, reach), 1);
  EXPECT_EQ(chain.triangles[1].nodes[0], 1);
  EXPECT_FALSE(chain.triangles[1].is_clear);
  EXPECT_TRUE(chain.triangles[0].is_clear) << "it has not moved";
}

TEST(SnapToNeighbours, an_edge_is_divided_at_a_vertex_near_it_in_all_its_triangles) {
  TriangleChain chain = two_triangles(flat, {{{2, little, 0}, {5, -5, 1}, {5, -5, -1}}});
  chain.vertices.push_back({1, -3, 0});
  chain.triangles.push_back({{1, 0, 6}, 1, 2, false, true});
  EXPECT_EQ(snap_to_neighbours(chain, {{0, 1}}, reach), 1);
  ASSERT_THAT(chain.triangles, SizeIs(5));
  int with_it = 0;
  for (const ChainTriangle& t : chain.triangles) {
    with_it += static_cast<int>(std::ranges::count(t.nodes, 3));
  }
  EXPECT_EQ(with_it, 5) << "two halves on each side, and its own";
}

TEST(SnapToNeighbours, two_edges_that_nearly_cross_get_a_common_vertex) {
  TriangleChain chain = two_triangles(flat, {{{2, -1, little}, {2, 1, little}, {2, 0, -5}}});
  EXPECT_EQ(snap_to_neighbours(chain, {{0, 1}}, reach), 2);
  ASSERT_THAT(chain.vertices, SizeIs(7));
  EXPECT_NEAR(norm(chain.vertices[6] - Vec3{2, 0, little / 2}), 0, 1e-12);
  EXPECT_THAT(chain.triangles, SizeIs(4));
}

TEST(SnapToNeighbours, a_triangle_is_divided_at_a_vertex_near_its_face) {
  TriangleChain chain = two_triangles(flat, {{{1, 1, -little}, {1, 2, 5}, {2, 1, 5}}});
  EXPECT_EQ(snap_to_neighbours(chain, {{0, 1}}, reach), 1);
  ASSERT_THAT(chain.triangles, SizeIs(4));
  for (std::size_t t = 1; t < 4; ++t) {
    EXPECT_THAT(chain.triangles[t].nodes, ::testing::Contains(3));
  }
}

TEST(SnapToNeighbours, what_is_farther_apart_stays) {
  TriangleChain chain = two_triangles(flat, {{{1, 1, -1}, {1, 2, 5}, {2, 1, 5}}});
  const TriangleChain before = chain;
  EXPECT_EQ(snap_to_neighbours(chain, {{0, 1}}, reach), 0);
  EXPECT_THAT(chain.triangles, SizeIs(2));
  EXPECT_EQ(chain.vertices, before.vertices);
}

}  // namespace
}  // namespace tetfarm
