#include "mesh/adaptation/edge_collapse.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/mesh/adaptation/plane_shapes.h"

namespace tetfarm {
namespace {

using testing::IsEmpty;

MetricMesh of_constant_metric(const PlaneMesh& plane, const Metric2& metric) {
  return plane_test::metric_mesh(plane, plane_test::constant_metrics(plane, metric));
}

void collapse_all(MetricMesh& mesh, const CollapseLimits& limits = {}) {
  for (int pass = 0; pass < 50; ++pass) {
    const std::int64_t gone = collapse_edges(mesh, limits, EdgesToVisit::all);
    ASSERT_THAT(validate(mesh), IsEmpty());
    if (gone == 0) return;
  }
  FAIL() << "it does not end";
}

std::int32_t node_at(const MetricMesh& mesh, const Vec2& place) {
  for (std::int32_t v = 0; v < mesh.nodes(); ++v) {
    const Vec2& p = mesh.complex.point(v);
    if (std::hypot(p.x - place.x, p.y - place.y) < 1e-9) return v;
  }
  return -1;
}

bool is_used_node(const MetricMesh& mesh, std::int32_t v) {
  return mesh.complex.node2triangle[at(v)] >= 0;
}

TEST(EdgeCollapse, takes_a_node_inside_away_and_leaves_the_other_where_it_is) {
  // Thesis, figure 33, where both ends go.
  MetricMesh mesh = of_constant_metric(plane_test::square(4), plane_test::round_metric(0.4));
  const std::int32_t node = node_at(mesh, {0.5, 0.5});
  const std::int32_t target = node_at(mesh, {0.75, 0.5});
  Ball ball;
  ASSERT_TRUE(collapse_node(mesh, node, target, {0.8, 1.5, 100}, ball));
  EXPECT_THAT(validate(mesh), IsEmpty());
  EXPECT_DOUBLE_EQ(plane_test::area(mesh.complex), 1);
  EXPECT_FALSE(is_used_node(mesh, node));
  EXPECT_EQ(mesh.complex.point(target), (Vec2{0.75, 0.5}));
  EXPECT_EQ(mesh.unused.size(), 2U);
}

TEST(EdgeCollapse, takes_a_node_of_the_border_along_its_curve_only) {
  // Thesis, figure 35.
  MetricMesh mesh = of_constant_metric(plane_test::square(4), plane_test::round_metric(0.4));
  const std::int32_t node = node_at(mesh, {0.5, 0});
  Ball ball;
  EXPECT_FALSE(collapse_node(mesh, node, node_at(mesh, {0.5, 0.25}), {}, ball));
  EXPECT_TRUE(is_used_node(mesh, node));
  const std::int32_t target = node_at(mesh, {0.75, 0});
  const std::int32_t beyond = node_at(mesh, {0.25, 0});
  const std::int32_t curve = curve_of_edge(mesh, node, target);
  ASSERT_TRUE(collapse_node(mesh, node, target, {0.8, 1.5, 100}, ball));
  EXPECT_THAT(validate(mesh), IsEmpty());
  EXPECT_DOUBLE_EQ(plane_test::area(mesh.complex), 1);
  EXPECT_EQ(curve_of_edge(mesh, target, beyond), curve);
  EXPECT_EQ(curve_of_edge(mesh, target, node), -1);
}

TEST(EdgeCollapse, never_takes_a_corner) {
  MetricMesh mesh = of_constant_metric(plane_test::square(4), plane_test::round_metric(0.4));
  Ball ball;
  const std::int32_t corner = node_at(mesh, {0, 0});
  EXPECT_FALSE(collapse_node(mesh, corner, node_at(mesh, {0.25, 0}), {}, ball));
  EXPECT_FALSE(collapse_node(mesh, corner, node_at(mesh, {0.25, 0.25}), {}, ball));
  EXPECT_TRUE(collapse_node(mesh, node_at(mesh, {0.25, 0}), corner, {0.8, 1.5, 100}, ball));
  EXPECT_THAT(validate(mesh), IsEmpty());
}

TEST(EdgeCollapse, coarsens_until_edges_fit) {
  for (const Metric2& metric : {plane_test::round_metric(0.3), Metric2{4, 0, 400}}) {
    MetricMesh mesh = of_constant_metric(plane_test::square(20), metric);
    collapse_all(mesh);
    EXPECT_NEAR(plane_test::area(mesh.complex), 1, 1e-13);
    const PlaneMesh left = plane_mesh_of(mesh).mesh;
    EXPECT_LT(left.points.size(), 120U);
    EXPECT_EQ(left.corners.size(), 4U);
    for (std::int32_t side = 1; side <= 4; ++side) {
      EXPECT_NEAR(plane_test::patch_lengths(left).at(side), 1, 1e-13);
    }
    double longest = 0;
    for (const auto& [a, b] : plane_test::edges_of(left)) {
      const Vec2 edge{left.points[at(b)].x - left.points[at(a)].x,
                      left.points[at(b)].y - left.points[at(a)].y};
      longest = std::max(longest, std::sqrt(squared_length(metric, edge)));
    }
    EXPECT_LE(longest, std::sqrt(2.0) + 1e-9) << "no new edge is longer, and none was";
  }
}

TEST(EdgeCollapse, leaves_nodes_of_the_border_where_they_are) {
  MetricMesh mesh = of_constant_metric(plane_test::disc(8), plane_test::round_metric(0.5));
  collapse_all(mesh, {0.7, 1.4, 100});
  EXPECT_EQ(plane_test::distance_from_curves(mesh), 0);
  const PlaneMesh left = plane_mesh_of(mesh).mesh;
  EXPECT_LT(left.edges.size(), 32U);
  for (const auto& [a, b] : left.edges) {
    EXPECT_NEAR(std::hypot(left.points[at(a)].x, left.points[at(a)].y), 1, 1e-14);
    EXPECT_EQ(std::count_if(left.edges.begin(), left.edges.end(),
                            [node = a](const auto& edge) { return edge[0] == node; }),
              1);
    EXPECT_NE(a, b);
  }
}

TEST(EdgeCollapse, leaves_an_edge_that_fits_and_one_whose_nodes_are_not_active) {
  MetricMesh mesh = of_constant_metric(plane_test::square(4), plane_test::round_metric(0.25));
  EXPECT_EQ(collapse_edges(mesh, {}, EdgesToVisit::all), 0);
  mesh = of_constant_metric(plane_test::square(4), plane_test::round_metric(1));
  EXPECT_EQ(collapse_edges(mesh, {}, EdgesToVisit::active), 0);
  mesh.active.assign(mesh.active.size(), 1);
  EXPECT_GT(collapse_edges(mesh, {}, EdgesToVisit::active), 0);
}

TEST(EdgeCollapse, makes_no_triangle_worse_than_the_limit) {
  MetricMesh mesh = of_constant_metric(plane_test::square(8), plane_test::round_metric(0.3));
  const CollapseLimits limits{0.7, 1.4, 30};
  double worst = 30;
  for (std::int32_t t = 0; t < mesh.complex.size(); ++t) {
    worst = std::max(worst, triangle_energy(mesh, mesh.complex.nodes(t)));
  }
  collapse_all(mesh, limits);
  for (std::int32_t t = 0; t < mesh.complex.size(); ++t) {
    if (!mesh.is_used(t)) continue;
    EXPECT_LE(triangle_energy(mesh, mesh.complex.nodes(t)), worst);
  }
}

TEST(EdgeCollapse, keeps_the_edge_between_regions) {
  MetricMesh mesh = of_constant_metric(plane_test::two_regions(8), plane_test::round_metric(2));
  collapse_all(mesh, {0.7, 1.4, 1e3});
  const PlaneMesh left = plane_mesh_of(mesh).mesh;
  EXPECT_LT(left.triangles.size(), 20U);
  EXPECT_NEAR(plane_test::region_areas(left).at(1), 1, 1e-14);
  EXPECT_NEAR(plane_test::region_areas(left).at(2), 1, 1e-14);
  EXPECT_NEAR(plane_test::patch_lengths(left).at(0), 1, 1e-14);
  EXPECT_NEAR(plane_test::patch_lengths(left).at(7), 6, 1e-14);
}

TEST(EdgeCollapse, never_closes_a_hole) {
  MetricMesh mesh =
      of_constant_metric(plane_test::square_with_hole(0.01, 4, 6), plane_test::round_metric(1));
  collapse_all(mesh, {0.7, 1.4, 1e6});
  const PlaneMesh left = plane_mesh_of(mesh).mesh;
  EXPECT_THAT(plane_test::whats_wrong(left), IsEmpty());
  EXPECT_TRUE(plane_test::patch_lengths(left).contains(2));
  EXPECT_LT(plane_test::area(left), 4 - 1e-6);
}

}  // namespace
}  // namespace tetfarm
