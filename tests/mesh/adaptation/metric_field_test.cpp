#include "mesh/adaptation/metric_field.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/mesh/adaptation/plane_shapes.h"

namespace tetfarm {
namespace {

void expect_same_metric(const Metric2& found, const Metric2& expected, double share) {
  const double error = share * (std::abs(expected.xx) + std::abs(expected.yy));
  EXPECT_NEAR(found.xx, expected.xx, error);
  EXPECT_NEAR(found.xy, expected.xy, error);
  EXPECT_NEAR(found.yy, expected.yy, error);
}

Metric2 turning_metric(const Vec2& p) {
  return metric_of_sizes({0.5 + 0.4 * p.x, 0.02 + 0.1 * p.y, 3 * p.x + p.y});
}

TEST(MetricField, gives_the_metric_of_a_node_there) {
  const PlaneMesh mesh = plane_test::square(6);
  const auto metrics = plane_test::metrics_of(mesh, turning_metric);
  const MetricField field = plane_test::field_of(mesh, metrics);
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    std::int32_t home = field.home_of_node(static_cast<std::int32_t>(v));
    expect_same_metric(field.at(mesh.points[v], home), metrics[v], 1e-12);
    home = 0;
    expect_same_metric(field.at(mesh.points[v], home), metrics[v], 1e-11);
  }
}

TEST(MetricField, is_constant_between_equal_metrics_and_outside) {
  const PlaneMesh mesh = plane_test::ell(3);
  const Metric2 metric = metric_of_sizes({1, 0.01, 0.7});
  const MetricField field = plane_test::field_of(mesh, plane_test::constant_metrics(mesh, metric));
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> place(-0.5, 2.5);
  std::int32_t home = 0;
  for (int i = 0; i < 1000; ++i) {
    expect_same_metric(field.at({place(random), place(random)}, home), metric, 1e-11);
  }
}

TEST(MetricField, interpolates_logarithms_linearly_in_a_triangle) {
  PlaneMesh mesh;
  mesh.points = {{0, 0}, {4, 0}, {0, 4}};
  mesh.triangles = {{0, 1, 2}};
  const std::vector<Metric2> metrics{{1, 0, 1}, {100, 0, 16}, {1e4, 0, 81}};
  const MetricField field = plane_test::field_of(mesh, metrics);
  std::int32_t home = 0;
  expect_same_metric(field.at({2, 0}, home), {10, 0, 4}, 1e-13);
  expect_same_metric(field.at({1, 0}, home), {std::sqrt(10), 0, 2}, 1e-13);
  expect_same_metric(field.at({0, 2}, home), {100, 0, 9}, 1e-13);
  expect_same_metric(field.at({2, 2}, home), {1000, 0, 36}, 1e-13);
  expect_same_metric(field.at({1, 2}, home), {std::sqrt(1e5), 0, 18}, 1e-13);
}

TEST(MetricField, outside_is_that_of_the_nearest_place_of_the_border) {
  const PlaneMesh mesh = plane_test::square(4);
  const auto metrics = plane_test::metrics_of(mesh, turning_metric);
  const MetricField field = plane_test::field_of(mesh, metrics);
  for (int i = 1; i < 20; ++i) {
    const double s = i / 20.0;
    for (const auto& [outside, beside] :
         {std::pair{Vec2{s, -1e-9}, Vec2{s, 0}}, std::pair{Vec2{s, 1 + 1e-9}, Vec2{s, 1}},
          std::pair{Vec2{-1e-9, s}, Vec2{0, s}}, std::pair{Vec2{1 + 1e-9, s}, Vec2{1, s}}}) {
      std::int32_t home = 0;
      const Metric2 found = field.at(outside, home);
      expect_same_metric(found, field.at(beside, home), 1e-6);
    }
  }
}

TEST(MetricField, far_outside_takes_the_nodes_of_the_border_alone) {
  const PlaneMesh mesh = plane_test::square(4);
  const auto metrics = plane_test::metrics_of(
      mesh, [](const Vec2& p) { return plane_test::round_metric(std::pow(10, -p.y)); });
  const MetricField field = plane_test::field_of(mesh, metrics);
  for (int i = 1; i < 20; ++i) {
    std::int32_t home = 0;
    expect_same_metric(field.at({i / 20.0, -0.1}, home), {1, 0, 1}, 1e-13);
    expect_same_metric(field.at({i / 20.0, 1.1}, home), {100, 0, 100}, 1e-13);
  }
}

TEST(MetricField, finds_the_triangle_of_a_point_from_any_other) {
  const PlaneMesh mesh = plane_test::square(50);
  const auto metrics = plane_test::metrics_of(mesh, turning_metric);
  const MetricField field = plane_test::field_of(mesh, metrics);
  const TriangleComplex& background = field.background();
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> share(0, 1);
  std::int32_t home = 0;
  for (int i = 0; i < 2000; ++i) {
    const Vec2 p{share(random), share(random)};
    const Metric2 found = field.at(p, home);
    const auto& [a, b, c] = background.nodes(home);
    EXPECT_GE(orient2d(background.point(a), background.point(b), p), 0) << i;
    EXPECT_GE(orient2d(background.point(b), background.point(c), p), 0) << i;
    EXPECT_GE(orient2d(background.point(c), background.point(a), p), 0) << i;
    // The second derivative of its logarithms is some tens; cells are 0.02 wide.
    const Metric2 exact = turning_metric(p);
    expect_same_metric(found, exact, 0.05);
  }
}

TEST(MetricField, has_densities_between_those_of_the_nodes) {
  const PlaneMesh mesh = plane_test::square(5);
  const auto metrics = plane_test::metrics_of(mesh, turning_metric);
  const MetricField field = plane_test::field_of(mesh, metrics);
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> share(0, 1);
  std::int32_t home = 0;
  for (int i = 0; i < 1000; ++i) {
    const double here = determinant(field.at({share(random), share(random)}, home));
    double least = HUGE_VAL;
    double most = 0;
    for (const std::int32_t v : field.background().nodes(home)) {
      least = std::min(least, determinant(metrics[at(v)]));
      most = std::max(most, determinant(metrics[at(v)]));
    }
    EXPECT_GE(here, least * (1 - 1e-9));
    EXPECT_LE(here, most * (1 + 1e-9));
  }
}

}  // namespace
}  // namespace tetfarm
