#include "mesh/adaptation/metric_smoothing.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "tests/mesh/adaptation/plane_shapes.h"

namespace tetfarm {
namespace {

using testing::IsEmpty;

double sum_of_energies(const MetricMesh& mesh) {
  double sum = 0;
  for (std::int32_t t = 0; t < mesh.complex.size(); ++t) {
    if (mesh.is_used(t)) sum += triangle_energy(mesh, mesh.complex.nodes(t));
  }
  return sum;
}

/// A mesh whose nodes inside are off their places by up to 0.3 of `cell`.
PlaneMesh disturbed(PlaneMesh mesh, double cell, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> share(-0.3 * cell, 0.3 * cell);
  std::vector<bool> is_on_border(mesh.points.size(), false);
  for (const auto& [a, b] : mesh.edges) is_on_border[at(a)] = is_on_border[at(b)] = true;
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    if (is_on_border[v]) continue;
    mesh.points[v] = {mesh.points[v].x + share(random), mesh.points[v].y + share(random)};
  }
  return mesh;
}

TEST(MetricSmoothing, never_raises_the_sum_of_energies) {
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    const PlaneMesh plane = disturbed(plane_test::square(10), 0.1, seed);
    const auto metrics = plane_test::metrics_of(plane, [](const Vec2& p) {
      return metric_of_sizes({0.1 + 0.1 * p.x, 0.05 + 0.1 * p.y, p.x});
    });
    MetricMesh mesh = plane_test::metric_mesh(plane, metrics);
    const MetricField field = plane_test::field_of(plane, metrics);
    double before = sum_of_energies(mesh);
    for (int sweep = 0; sweep < 5; ++sweep) {
      mesh.active.assign(mesh.active.size(), 1);
      EXPECT_GT(smooth_nodes(mesh, field), 0);
      EXPECT_THAT(validate(mesh), IsEmpty());
      EXPECT_LT(sum_of_energies(mesh), before);
      before = sum_of_energies(mesh);
    }
    EXPECT_NEAR(plane_test::area(mesh.complex), 1, 1e-13);
  }
}

TEST(MetricSmoothing, leaves_corners_and_keeps_nodes_of_curves_on_them) {
  const PlaneMesh plane = plane_test::two_regions(6);
  const auto metrics = plane_test::metrics_of(
      plane, [](const Vec2& p) { return plane_test::round_metric(0.05 + 0.1 * p.x + 0.1 * p.y); });
  MetricMesh mesh = plane_test::metric_mesh(plane, metrics);
  const MetricField field = plane_test::field_of(plane, metrics);
  const MetricMesh before = mesh;
  for (int sweep = 0; sweep < 10; ++sweep) {
    mesh.active.assign(mesh.active.size(), 1);
    smooth_nodes(mesh, field);
  }
  EXPECT_THAT(validate(mesh), IsEmpty());
  EXPECT_LE(plane_test::distance_from_curves(mesh), 1e-15);
  int moved_on_curves = 0;
  for (std::int32_t v = 0; v < mesh.nodes(); ++v) {
    if (mesh.curve_of_node[at(v)] == MetricMesh::corner) {
      EXPECT_EQ(mesh.complex.point(v), before.complex.point(v));
    } else if (!mesh.is_inside(v)) {
      moved_on_curves += mesh.complex.point(v) == before.complex.point(v) ? 0 : 1;
    }
  }
  EXPECT_GT(moved_on_curves, 10);
  const PlaneMesh smoothed = plane_mesh_of(mesh).mesh;
  EXPECT_NEAR(plane_test::region_areas(smoothed).at(1), 1, 1e-14);
  EXPECT_NEAR(plane_test::patch_lengths(smoothed).at(0), 1, 1e-14);
  EXPECT_NEAR(plane_test::patch_lengths(smoothed).at(7), 6, 1e-14);
}

TEST(MetricSmoothing, keeps_nodes_of_a_circle_on_it_even_where_it_closes) {
  const PlaneMesh plane = plane_test::disc(5);
  const auto metrics = plane_test::metrics_of(
      plane, [](const Vec2& p) { return plane_test::round_metric(0.25 + 0.15 * p.y); });
  MetricMesh mesh = plane_test::metric_mesh(plane, metrics);
  const MetricField field = plane_test::field_of(plane, metrics);
  for (int sweep = 0; sweep < 20; ++sweep) {
    mesh.active.assign(mesh.active.size(), 1);
    smooth_nodes(mesh, field);
    ASSERT_THAT(validate(mesh), IsEmpty());
  }
  EXPECT_LE(plane_test::distance_from_curves(mesh), 1e-15);
  for (std::int32_t v = 0; v < mesh.nodes(); ++v) {
    if (mesh.is_inside(v)) continue;
    EXPECT_NEAR(std::hypot(mesh.complex.point(v).x, mesh.complex.point(v).y), 1, 1e-4);
    EXPECT_GE(mesh.parameters[at(v)], 0);
    EXPECT_LT(mesh.parameters[at(v)], mesh.curves[0].shape.length());
  }
}

TEST(MetricSmoothing, centres_a_node_in_its_ring) {
  PlaneMesh plane;
  plane.points = {{0.2, -0.1}};
  for (int i = 0; i < 6; ++i) {
    plane.points.push_back(
        {std::cos(i * std::numbers::pi / 3), std::sin(i * std::numbers::pi / 3)});
    plane.triangles.push_back({0, i + 1, (i + 1) % 6 + 1});
  }
  for (const double stretch : {1.0, 0.05}) {
    PlaneMesh ring = plane;
    for (Vec2& p : ring.points) p.y *= stretch;
    const auto metrics = plane_test::constant_metrics(ring, {1, 0, 1 / (stretch * stretch)});
    MetricMesh mesh = plane_test::metric_mesh(ring, metrics);
    const MetricField field = plane_test::field_of(ring, metrics);
    for (int sweep = 0; sweep < 40; ++sweep) {
      mesh.active[0] = 1;
      smooth_nodes(mesh, field);
    }
    EXPECT_NEAR(mesh.complex.point(0).x, 0, 0.01);
    EXPECT_NEAR(mesh.complex.point(0).y, 0, 0.01 * stretch);
  }
}

TEST(MetricSmoothing, moves_active_nodes_alone_and_takes_the_metric_of_the_new_place) {
  const PlaneMesh plane = disturbed(plane_test::square(6), 1.0 / 6, 5);
  const auto metrics = plane_test::metrics_of(
      plane, [](const Vec2& p) { return plane_test::round_metric(0.1 + 0.1 * p.x); });
  MetricMesh mesh = plane_test::metric_mesh(plane, metrics);
  const MetricField field = plane_test::field_of(plane, metrics);
  EXPECT_EQ(smooth_nodes(mesh, field), 0);
  EXPECT_EQ(mesh.complex.points, plane.points);
  mesh.active.assign(mesh.active.size(), 1);
  EXPECT_GT(smooth_nodes(mesh, field), 10);
  for (std::int32_t v = 0; v < mesh.nodes(); ++v) {
    std::int32_t home = mesh.homes[at(v)];
    const Metric2 there = field.at(mesh.complex.point(v), home);
    EXPECT_NEAR(mesh.metrics[at(v)].xx / there.xx, 1, 1e-12);
  }
}

}  // namespace
}  // namespace tetfarm
