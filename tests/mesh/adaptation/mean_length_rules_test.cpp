#include "mesh/adaptation/mean_length_rules.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "mesh/adaptation/adapt_mesh.h"
#include "mesh/adaptation/circle_curve.h"
#include "tests/mesh/adaptation/plane_shapes.h"

namespace tetfarm {
namespace {

using testing::IsEmpty;

AdaptationOptions by_mean_length() {
  AdaptationOptions options;
  options.rules = EdgeRules::mean_length;
  options.cavity.rings = 1;
  return options;
}

/// Thrice as fine at x = 1 as at x = 0.
Metric2 finer_to_the_right(const Vec2& p) { return plane_test::round_metric(0.1 / (1 + 2 * p.x)); }

TEST(MeanLengthRules, take_the_mean_of_all_edges) {
  PlaneMesh triangle;
  triangle.points = {{0, 0}, {3, 0}, {0, 4}};
  triangle.triangles = {{0, 1, 2}};
  EXPECT_DOUBLE_EQ(mean_edge_length(checked_complex(triangle), std::vector<Metric2>(3)), 4);
}

TEST(MeanLengthRules, leave_an_even_mesh_as_it_is_however_coarse) {
  // The trap of equation 16: nothing says that there are too few nodes.
  const PlaneMesh disc = plane_test::disc(1);
  for (const double size : {1e-2, 1.0, 1e2}) {
    const AdaptationResult result = adapt_mesh(
        disc, plane_test::constant_metrics(disc, plane_test::round_metric(size)), by_mean_length());
    EXPECT_EQ(result.mesh.points.size(), disc.points.size());
    EXPECT_EQ(result.mesh.triangles.size(), disc.triangles.size());
    EXPECT_NEAR(result.mean_length_before, 1 / size, 1e-12 / size);
    EXPECT_NEAR(result.mean_length_after, 1 / size, 1e-12 / size);
  }
}

TEST(MeanLengthRules, leave_no_edge_longer_than_allowed_but_a_few) {
  const PlaneMesh square = plane_test::square(20);
  const AdaptationResult result =
      adapt_mesh(square, plane_test::metrics_of(square, finer_to_the_right), by_mean_length());
  EXPECT_THAT(plane_test::whats_wrong(result.mesh), IsEmpty());
  EXPECT_NEAR(plane_test::area(result.mesh), 1, 1e-13);
  int too_long = 0;
  int too_short = 0;
  int edges = 0;
  for (const auto& [a, b] : plane_test::edges_of(result.mesh)) {
    const Vec2& p = result.mesh.points[at(a)];
    const Vec2& q = result.mesh.points[at(b)];
    const double length =
        length_between({q.x - p.x, q.y - p.y}, result.metrics[at(a)], result.metrics[at(b)]);
    ++edges;
    too_long += length > 1.25 ? 1 : 0;
    too_short += length < 0.6 ? 1 : 0;
  }
  EXPECT_LT(too_long, 0.02 * edges);
  EXPECT_LT(too_short, 0.03 * edges);
}

TEST(MeanLengthRules, move_nodes_to_where_the_metric_is_fine) {
  const PlaneMesh square = plane_test::square(20);
  const auto right_of_middle = [](const PlaneMesh& mesh) {
    double right = 0;
    for (const Vec2& p : mesh.points) right += p.x > 0.5 ? 1 : 0;
    return right / static_cast<double>(mesh.points.size());
  };
  const AdaptationResult result =
      adapt_mesh(square, plane_test::metrics_of(square, finer_to_the_right), by_mean_length());
  EXPECT_NEAR(right_of_middle(square), 0.5, 0.05);
  // The integral of (1 + 2 x)² is 3.67 right of the middle, of 4.33.
  EXPECT_GT(right_of_middle(result.mesh), 0.68);
}

TEST(MeanLengthRules, keep_nodes_of_the_boundary_on_its_curve) {
  const PlaneMesh disc = plane_test::disc(6);
  AdaptationOptions options = by_mean_length();
  options.curves = {{{5}, "circle", {std::make_shared<const CircleCurve>(Circle{{0, 0}, 1})}}};
  const auto metrics = plane_test::metrics_of(
      disc, [](const Vec2& p) { return plane_test::round_metric(0.05 + 0.2 * std::abs(p.x)); });
  const AdaptationResult result = adapt_mesh(disc, metrics, options);
  EXPECT_NE(result.mesh.edges.size(), disc.edges.size());
  for (const auto& [a, b] : result.mesh.edges) {
    EXPECT_NEAR(std::hypot(result.mesh.points[at(a)].x, result.mesh.points[at(a)].y), 1, 1e-14);
    EXPECT_NE(a, b);
  }
}

TEST(MeanLengthRules, end_where_nothing_is_left_to_do) {
  const PlaneMesh square = plane_test::square(8);
  const auto metrics = plane_test::constant_metrics(square, plane_test::round_metric(0.125));
  MetricMesh mesh = plane_test::metric_mesh(square, metrics);
  const MetricField field = plane_test::field_of(square, metrics);
  EllipseCavity cavity({EllipseTest::at_apex_too, 1});
  // Diagonals are sqrt 2 long.
  EXPECT_EQ(adapt_by_mean_length(mesh, field, cavity, {0.8, 1.42, 20}), 1);
  EXPECT_EQ(mesh.nodes(), 81);
}

}  // namespace
}  // namespace tetfarm
