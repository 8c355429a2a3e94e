#include "mesh/adaptation/border_nodes.h"

#include <gtest/gtest.h>

#include "mesh/adaptation/edge_collapse.h"
#include "tests/mesh/adaptation/plane_shapes.h"

namespace tetfarm {
namespace {

std::int32_t node_at(const MetricMesh& mesh, double x, double y) {
  for (std::int32_t v = 0; v < mesh.nodes(); ++v) {
    if (mesh.complex.point(v) == Vec2{x, y}) return v;
  }
  return -1;
}

MetricMesh mesh_of(const PlaneMesh& plane) {
  return plane_test::metric_mesh(plane, plane_test::constant_metrics(plane, {}));
}

TEST(BorderNodes, are_found_in_a_triangle_and_on_its_sides_whatever_way_it_turns) {
  const MetricMesh mesh = mesh_of(plane_test::square(4));
  const BorderNodes border(mesh);
  const std::int32_t a = node_at(mesh, 0, 0);
  const std::int32_t b = node_at(mesh, 0.5, 0);
  const std::int32_t c = node_at(mesh, 0, 0.5);
  EXPECT_TRUE(border.any_in_triangle(mesh, a, b, c));
  EXPECT_TRUE(border.any_in_triangle(mesh, a, c, b));
}

TEST(BorderNodes, are_none_of_those_inside_nor_the_three_themselves) {
  const MetricMesh mesh = mesh_of(plane_test::square(4));
  const BorderNodes border(mesh);
  // The nodes in this triangle lie inside the square.
  EXPECT_FALSE(border.any_in_triangle(mesh, node_at(mesh, 0.25, 0), node_at(mesh, 0.5, 0.75),
                                      node_at(mesh, 0.25, 0.75)));
  EXPECT_FALSE(border.any_in_triangle(mesh, node_at(mesh, 0, 0), node_at(mesh, 0.25, 0),
                                      node_at(mesh, 0, 0.25)));
}

TEST(BorderNodes, that_went_are_in_no_way) {
  MetricMesh mesh = mesh_of(plane_test::square(4));
  const BorderNodes border(mesh);
  Ball ball;
  ASSERT_TRUE(collapse_node(mesh, node_at(mesh, 0.25, 0), node_at(mesh, 0, 0), {1, 2, 1e3}, ball));
  EXPECT_FALSE(border.any_in_triangle(mesh, node_at(mesh, 0, 0), node_at(mesh, 0.5, 0),
                                      node_at(mesh, 0.25, 0.25)));
}

}  // namespace
}  // namespace tetfarm
