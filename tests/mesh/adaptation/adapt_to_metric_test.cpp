#include "mesh/adaptation/adapt_to_metric.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

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
