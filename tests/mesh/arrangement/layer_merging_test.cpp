#include "mesh/arrangement/layer_merging.h"

#include <gmock/gmock.h>

#include <cmath>

namespace tetfarm {
namespace {

using ::testing::SizeIs;

double area_with_sign(const TriangleChain& chain) {
  double area = 0;
  for (std::size_t t = 0; t < chain.triangles.size(); ++t) {
    const TrianglePoints p = chain.points_of(static_cast<std::int32_t>(t));
    area += chain.triangles[t].times * cross(p[1] - p[0], p[2] - p[0]).z / 2;
  }
  return area;
}

/// A large triangle, and a smaller one over a part of it that is not quite parallel.
TriangleChain layers(const Triangle& upper) {
  TriangleChain chain;
  chain.vertices = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, -1e-9}, {3, 3, 1e-9}, {1, 3, 1e-9}};
  chain.triangles = {{{0, 1, 2}, 1, 7, false, false}, {upper, 1, 8, false, false}};
  return chain;
}

TEST(LayerMerging, faces_that_nearly_lie_on_each_other_share_their_triangles) {
  TriangleChain chain = layers({3, 4, 5});
  EXPECT_TRUE(merge_layers(chain, {{0, 1}}, 1e-6));
  EXPECT_NEAR(area_with_sign(chain), 8 + 2, 1e-6);
  merge_equals(chain);
  EXPECT_THAT(meeting_pairs(chain).value(), SizeIs(0));
  double twice = 0;
  for (const ChainTriangle& t : chain.triangles) {
    const TrianglePoints p = triangle_points(chain.vertices, t.nodes);
    if (t.times == 2) twice += norm(cross(p[1] - p[0], p[2] - p[0])) / 2;
    EXPECT_EQ(t.patch, p[0].x + p[1].x + p[2].x + p[0].y + p[1].y + p[2].y > 12.1 ? 8 : 7);
  }
  EXPECT_NEAR(twice, 1, 1e-6) << "half of the smaller one lies over the larger one";
}

TEST(LayerMerging, what_is_back_to_back_is_gone) {
  TriangleChain chain = layers({3, 5, 4});
  EXPECT_TRUE(merge_layers(chain, {{0, 1}}, 1e-6));
  EXPECT_NEAR(area_with_sign(chain), 8 - 2, 1e-6);
  for (const ChainTriangle& t : chain.triangles) EXPECT_EQ(t.times, 1);
}

TEST(LayerMerging, an_edge_that_is_divided_is_so_in_triangles_beside_the_layer) {
  TriangleChain chain = layers({3, 4, 5});
  chain.vertices.push_back({4, 4, 5});
  chain.triangles.push_back({{2, 1, 6}, 1, 9, false, true});
  EXPECT_TRUE(merge_layers(chain, {{0, 1}}, 1e-6));
  int beside = 0;
  for (const ChainTriangle& t : chain.triangles) {
    if (t.patch != 9) continue;
    ++beside;
    EXPECT_FALSE(t.is_clear);
  }
  EXPECT_EQ(beside, 3) << "the smaller one has two edges across it";
}

TEST(LayerMerging, leaves_faces_that_go_through_each_other) {
  TriangleChain chain = layers({3, 4, 5});
  chain.vertices[3].z = -1;
  EXPECT_FALSE(merge_layers(chain, {{0, 1}}, 1e-6));
  EXPECT_THAT(chain.triangles, SizeIs(2));
}

}  // namespace
}  // namespace tetfarm
