#include "mesh/render/patch_curve.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tetfarm {
namespace {

using ::testing::ElementsAre;
using Nodes = std::vector<std::int32_t>;

/// Edges alone, which is all that lines are made of.
PlaneMesh of_edges(std::vector<std::array<std::int32_t, 2>> edges, Nodes patches) {
  PlaneMesh mesh;
  for (int i = 0; i < 8; ++i) mesh.points.push_back({0.5 * i, 0});
  mesh.edges = std::move(edges);
  mesh.patches = std::move(patches);
  return mesh;
}

TEST(PatchCurve, leads_from_end_to_end_however_the_edges_run) {
  const PlaneMesh mesh = of_edges({{3, 1}, {3, 5}, {0, 1}, {5, 6}}, {1, 1, 1, 2});
  EXPECT_THAT(patch_lines(mesh, Nodes{1}), ElementsAre(Nodes{0, 1, 3, 5}));
  EXPECT_THAT(patch_lines(mesh, Nodes{2, 1}), ElementsAre(Nodes{0, 1, 3, 5, 6}));
  EXPECT_TRUE(patch_lines(mesh, Nodes{7}).empty());
}

TEST(PatchCurve, closes_a_loop_at_its_lowest_node) {
  const PlaneMesh mesh = of_edges({{4, 2}, {6, 4}, {2, 6}, {1, 0}}, {1, 1, 1, 1});
  EXPECT_THAT(patch_lines(mesh, Nodes{1}), ElementsAre(Nodes{0, 1}, Nodes{2, 4, 6, 2}));
}

TEST(PatchCurve, ends_where_three_edges_meet) {
  const PlaneMesh mesh = of_edges({{0, 3}, {3, 4}, {3, 5}}, {1, 1, 1});
  EXPECT_THAT(patch_lines(mesh, Nodes{1}), ElementsAre(Nodes{0, 3}, Nodes{3, 4}, Nodes{3, 5}));
}

TEST(PatchCurve, has_the_values_at_the_places_of_the_nodes) {
  const PlaneMesh mesh = of_edges({{2, 1}, {2, 7}}, {1, 1});
  const std::vector<double> values = {0, 10, 20, 30, 40, 50, 60, 70};
  EXPECT_THAT(values_over_x(mesh, values, Nodes{1}),
              ElementsAre(ElementsAre(Vec2{0.5, 10}, Vec2{1, 20}, Vec2{3.5, 70})));
}

}  // namespace
}  // namespace tetfarm
