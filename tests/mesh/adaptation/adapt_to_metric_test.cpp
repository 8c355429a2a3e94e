#include "mesh/adaptation/adapt_to_metric.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "base/array_index.h"
#include "base/error.h"
#include "mesh/adaptation/checked_plane_mesh.h"
#include "mesh/adaptation/metric_quality.h"
#include "tests/mesh/adaptation/plane_shapes.h"

namespace tetfarm {
namespace {

std::vector<Metric2> across_the_middle(const PlaneMesh& mesh) {
  std::vector<Metric2> metrics;
  for (const Vec2& p : mesh.points) {
    metrics.push_back(metric_of_sizes({0.01 + std::abs(p.x - 0.5), 0.5, 0}));
  }
  return metrics;
}

TEST(AdaptToMetric, has_the_vertices_asked_for_within_five_percent) {
  const PlaneMesh mesh = plane_test::square(20);
  const std::vector<Metric2> metrics = across_the_middle(mesh);
  for (const std::int64_t wanted : {150, 1000, 6000}) {
    AdaptationWish wish{metrics, {0, 0.4, 1e3, 1.5}, wanted};
    const AdaptedMesh adapted = adapt_to_metric(mesh, checked_complex(mesh), wish);
    const auto vertices = static_cast<double>(adapted.result.mesh.points.size());
    EXPECT_NEAR(vertices / static_cast<double>(wanted), 1, 0.05) << wanted;
  }
}

TEST(AdaptToMetric, without_a_number_the_metric_is_taken_as_it_is) {
  const PlaneMesh mesh = plane_test::square(10);
  const std::vector<Metric2> metrics(mesh.points.size(), metric_of_sizes({0.05, 0.05, 0}));
  const AdaptedMesh adapted = adapt_to_metric(mesh, checked_complex(mesh), {metrics, {}, {}});
  EXPECT_NEAR(adapted.asked.complexity, 400, 1e-6);
  for (const Metric2& m : adapted.result.metrics) EXPECT_NEAR(m.xx, 400, 1e-6);
}

/// Two lines across the unit square: figure 29 of the thesis.
std::vector<MetricSource> crossing_lines(double growth) {
  MetricSource rising;
  rising.from = {0, 0};
  rising.to = {1, 1};
  rising.along = 0.06;
  rising.across = 0.015;
  rising.radius = 0.06;
  rising.growth = growth;
  MetricSource falling = rising;
  falling.from = {0, 1};
  falling.to = {1, 0};
  return {rising, falling};
}

AdaptedMesh adapted_to_sources(const PlaneMesh& mesh, const MetricSources& sources, double size,
                               std::optional<std::int64_t> vertices = std::nullopt) {
  const auto metrics = plane_test::constant_metrics(mesh, plane_test::round_metric(size));
  AdaptationOptions options;
  options.sources = &sources;
  return adapt_to_metric(mesh, checked_complex(mesh), {metrics, {}, vertices}, options);
}

/// Mean lengths of the edges of an area, each within 20 degrees of a direction.
template <class Area>
double mean_length_along(const PlaneMesh& mesh, double angle_deg, const Area& area) {
  double sum = 0;
  int count = 0;
  const double angle = angle_deg * std::numbers::pi / 180;
  for (const auto& [a, b] : plane_test::edges_of(mesh)) {
    const Vec2& p = mesh.points[at(a)];
    const Vec2& q = mesh.points[at(b)];
    const double length = std::hypot(q.x - p.x, q.y - p.y);
    const double along = (q.x - p.x) * std::cos(angle) + (q.y - p.y) * std::sin(angle);
    if (!area(p) || !area(q) || std::abs(along) < std::cos(20 * std::numbers::pi / 180) * length) {
      continue;
    }
    sum += length;
    ++count;
  }
  EXPECT_GT(count, 5) << angle_deg;
  return sum / count;
}

TEST(AdaptToSources, stretches_triangles_along_crossing_lines_and_not_where_they_cross) {
  const MetricSources sources(crossing_lines(1.4));
  const PlaneMesh mesh = adapted_to_sources(plane_test::square(2), sources, 0.1).result.mesh;
  EXPECT_TRUE(plane_test::whats_wrong(mesh).empty());
  const auto of_rising = [](const Vec2& p) {
    return std::abs(p.x - p.y) < 0.06 && (p.x < 0.35 || p.x > 0.65);
  };
  EXPECT_NEAR(mean_length_along(mesh, 45, of_rising), 0.06, 0.012);
  EXPECT_NEAR(mean_length_along(mesh, 135, of_rising), 0.015, 0.003);
  const auto of_falling = [](const Vec2& p) {
    return std::abs(p.x + p.y - 1) < 0.06 && (p.x < 0.35 || p.x > 0.65);
  };
  EXPECT_NEAR(mean_length_along(mesh, 135, of_falling), 0.06, 0.012);
  EXPECT_NEAR(mean_length_along(mesh, 45, of_falling), 0.015, 0.003);
  const auto of_crossing = [](const Vec2& p) {
    return std::abs(p.x - 0.5) + std::abs(p.y - 0.5) < 0.08;
  };
  for (const double angle : {0.0, 45.0, 90.0, 135.0}) {
    EXPECT_NEAR(mean_length_along(mesh, angle, of_crossing), 0.015, 0.002) << angle;
  }
  const auto of_rest = [](const Vec2& p) { return p.y < 0.15 && std::abs(p.x - 0.5) < 0.15; };
  EXPECT_NEAR(mean_length_along(mesh, 0, of_rest), 0.09, 0.03);
}

TEST(AdaptToSources, has_unit_edges_by_the_metric_of_the_sources_wherever_it_began) {
  const MetricSources sources(crossing_lines(1.4));
  const auto metric_at = [&](const Vec2& p) { return sources.at(p, {100, 0, 100}); };
  for (const int n : {1, 5, 40}) {
    const AdaptedMesh adapted = adapted_to_sources(plane_test::square(n), sources, 0.1);
    const MetricQuality quality =
        metric_quality(checked_complex(adapted.result.mesh), adapted.result.metrics);
    EXPECT_GT(plane_test::share_of_unit_edges(adapted.result.mesh, metric_at), 0.99) << n;
    EXPECT_GT(quality.quality_min, 0.5) << n;
    EXPECT_GT(quality.quality_mean, 0.93) << n;
    const double expected = nodes_per_complexity * adapted.asked.complexity;
    EXPECT_NEAR(static_cast<double>(adapted.result.mesh.points.size()) / expected, 1, 0.15) << n;
  }
}

TEST(AdaptToSources, fills_sources_that_end_at_their_radius_from_two_triangles_on) {
  for (const double growth : {0.0, 20.0}) {
    MetricSource source = crossing_lines(growth).front();
    source.from = {0.2, 0.18};
    source.to = {0.7, 0.47};
    source.radius = 0.06;
    const MetricSources sources({source});
    const PlaneMesh mesh = adapted_to_sources(plane_test::square(1), sources, 0.5).result.mesh;
    int within = 0;
    for (const Vec2& p : mesh.points) within += sources.at(p, {4, 0, 4}).xx > 300 ? 1 : 0;
    // Two triangles of the sizes for each node; the outermost of them reach beyond the radius.
    const double nodes = (0.12 * 0.578 + 0.0113) / (0.06 * 0.015 * 0.866);
    EXPECT_GT(within, 0.65 * nodes) << growth;
    EXPECT_LT(within, 1.3 * nodes) << growth;
  }
}

TEST(AdaptToSources, takes_the_metric_exactly_where_the_nodes_are) {
  const MetricSources sources(crossing_lines(0));
  const AdaptedMesh adapted = adapted_to_sources(plane_test::square(2), sources, 0.1);
  for (std::size_t v = 0; v < adapted.result.mesh.points.size(); ++v) {
    const Metric2 expected = sources.at(adapted.result.mesh.points[v], {100, 0, 100});
    const Metric2& found = adapted.result.metrics[v];
    EXPECT_NEAR(found.xx, expected.xx, 1e-9 * expected.xx) << v;
    EXPECT_NEAR(found.xy, expected.xy, 1e-9 * expected.xx) << v;
  }
}

TEST(AdaptToSources, finds_a_source_that_is_far_smaller_than_any_triangle) {
  MetricSource source;
  source.from = source.to = {0.3123, 0.277};
  source.along = source.across = 1e-6;
  source.radius = 4e-6;
  const PlaneMesh mesh =
      adapted_to_sources(plane_test::square(1), MetricSources({source}), 0.2).result.mesh;
  int within = 0;
  for (const Vec2& p : mesh.points) {
    within += std::hypot(p.x - source.from.x, p.y - source.from.y) < source.radius ? 1 : 0;
  }
  EXPECT_NEAR(within, 1.155 * std::numbers::pi * 16, 20);
  EXPECT_LT(mesh.points.size(), 1500U);
}

TEST(AdaptToSources, keeps_the_sizes_of_sources_whatever_number_of_vertices_is_asked_for) {
  const MetricSources sources(crossing_lines(1.4));
  const PlaneMesh square = plane_test::square(2);
  const PlaneMesh mesh = adapted_to_sources(square, sources, 0.1, 2500).result.mesh;
  EXPECT_NEAR(static_cast<double>(mesh.points.size()), 2500, 125);
  const auto of_crossing = [](const Vec2& p) {
    return std::abs(p.x - 0.5) + std::abs(p.y - 0.5) < 0.08;
  };
  EXPECT_NEAR(mean_length_along(mesh, 45, of_crossing), 0.015, 0.002);
  EXPECT_THROW(adapted_to_sources(square, sources, 0.1, 100), InvalidInput);
}

TEST(AdaptToSources, refuses_what_is_too_much_before_it_begins) {
  std::vector<MetricSource> sources = crossing_lines(1.4);
  for (MetricSource& source : sources) source.along = source.across = 1e-9;
  EXPECT_THROW(adapted_to_sources(plane_test::square(2), MetricSources(sources), 0.1),
               InvalidInput);
}

TEST(AdaptToSources, keeps_the_border_on_its_curve) {
  MetricSource source;
  source.from = source.to = {1, 0};
  source.along = source.across = 0.01;
  source.radius = 0.05;
  const PlaneMesh mesh =
      adapted_to_sources(plane_test::disc(4), MetricSources({source}), 0.25).result.mesh;
  EXPECT_TRUE(plane_test::whats_wrong(mesh).empty());
  int near = 0;
  for (const auto& [a, b] : mesh.edges) {
    const Vec2& p = mesh.points[at(a)];
    EXPECT_NEAR(std::hypot(p.x, p.y), 1, 1e-4);
    near += std::abs(p.y) < 0.05 && p.x > 0 ? 1 : 0;
  }
  EXPECT_GT(near, 7);
}

TEST(MetricQuality, of_an_equilateral_triangle_of_unit_edges_is_one) {
  PlaneMesh mesh;
  mesh.points = {{0, 0}, {1, 0}, {0.5, std::sqrt(0.75)}};
  mesh.triangles = {{0, 1, 2}};
  const std::vector<Metric2> unit(3);
  const MetricQuality quality = metric_quality(checked_complex(mesh), unit);
  EXPECT_NEAR(quality.quality_min, 1, 1e-12);
  EXPECT_NEAR(quality.quality_mean, 1, 1e-12);
  EXPECT_NEAR(quality.edge_length_min, 1, 1e-12);
  EXPECT_NEAR(quality.edge_length_max, 1, 1e-12);
  EXPECT_NEAR(quality.max_angle_deg, 60, 1e-9);
  EXPECT_EQ(quality.unit_edges_percent, 100);
}

TEST(MetricQuality, names_the_longest_edge_and_the_worst_triangle) {
  PlaneMesh mesh;
  mesh.points = {{0, 0}, {1, 0}, {0.5, std::sqrt(0.75)}, {0.5, -3}};
  mesh.triangles = {{0, 1, 2}, {1, 0, 3}};
  const std::vector<Metric2> unit(4);
  const MetricQuality quality = metric_quality(checked_complex(mesh), unit);
  EXPECT_NEAR(quality.edge_length_max, std::hypot(0.5, 3), 1e-12);
  EXPECT_NEAR(quality.longest_at.y, -1.5, 1e-12);
  EXPECT_NEAR(quality.worst_at.y, -1, 1e-12);
  EXPECT_NEAR(quality.unit_edges_percent, 60, 1e-9);
}

}  // namespace
}  // namespace tetfarm
