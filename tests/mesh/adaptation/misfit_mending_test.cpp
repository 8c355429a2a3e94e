#include "mesh/adaptation/misfit_mending.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/mesh/adaptation/plane_shapes.h"

namespace tetfarm {
namespace {

using testing::IsEmpty;

/// The strip of equilateral triangles with edges of length 1; node 5 is inside.
PlaneMesh honeycomb(const Vec2& middle) {
  const double h = std::sqrt(0.75);
  PlaneMesh mesh;
  mesh.points = {{0, 0}, {1, 0},   {2, 0},     {-0.5, h}, {1.5, h},
                 middle, {2.5, h}, {0, 2 * h}, {1, 2 * h}};
  mesh.triangles = {{0, 1, 5}, {1, 4, 5}, {1, 2, 4}, {2, 6, 4},
                    {0, 5, 3}, {3, 5, 7}, {5, 8, 7}, {5, 4, 8}};
  return mesh;
}

const Vec2 right_place{0.5, std::sqrt(0.75)};

double worst_energy_of(const MetricMesh& mesh) {
  double worst = 0;
  for (const auto& nodes : mesh.complex.triangles) {
    worst = std::max(worst, triangle_energy(mesh, nodes));
  }
  return worst;
}

TEST(MisfitMending, energy_is_four_of_the_unit_triangle_and_infinite_when_it_does_not_turn) {
  const PlaneMesh plane = honeycomb(right_place);
  const MetricMesh mesh =
      plane_test::metric_mesh(plane, plane_test::constant_metrics(plane, {1, 0, 1}));
  for (const auto& nodes : mesh.complex.triangles) {
    EXPECT_NEAR(triangle_energy(mesh, nodes), 4, 1e-13);
    EXPECT_EQ(triangle_energy(mesh, {nodes[1], nodes[0], nodes[2]}), HUGE_VAL);
  }
  EXPECT_EQ(triangle_energy(mesh, {0, 1, 2}), HUGE_VAL) << "flat";
  // Twice as large: |J|² = 8 and |J⁻¹|² = 1/2.
  const MetricMesh large =
      plane_test::metric_mesh(plane, plane_test::constant_metrics(plane, {4, 0, 4}));
  EXPECT_NEAR(triangle_energy(large, large.complex.nodes(0)), 8.5, 1e-13);
  const MetricMesh wide =
      plane_test::metric_mesh(plane, plane_test::constant_metrics(plane, {4, 0, 1}));
  EXPECT_NEAR(triangle_energy(wide, wide.complex.nodes(0)), 5 + 1.25, 1e-13);
}

TEST(MisfitMending, finds_no_misfits_among_unit_triangles) {
  const PlaneMesh plane = honeycomb(right_place);
  MetricMesh mesh = plane_test::metric_mesh(plane, plane_test::constant_metrics(plane, {1, 0, 1}));
  EXPECT_EQ(activate_misfits(mesh, {}), 0);
  EXPECT_EQ(std::count(mesh.active.begin(), mesh.active.end(), 1), 0);
  const MetricField field =
      plane_test::field_of(plane, plane_test::constant_metrics(plane, {1, 0, 1}));
  EXPECT_EQ(mend_misfits(mesh, field, {}), 0);
  EXPECT_EQ(mesh.complex.points, plane.points);
}

TEST(MisfitMending, marks_the_nodes_of_a_long_edge_and_of_a_short_one) {
  const PlaneMesh plane = honeycomb(right_place);
  for (const double h : {0.7, 1.5}) {
    MetricMesh mesh = plane_test::metric_mesh(
        plane, plane_test::constant_metrics(plane, plane_test::round_metric(h)));
    EXPECT_EQ(activate_misfits(mesh, {0.69, 1.31, 1e9}), 8) << h;
    EXPECT_EQ(std::count(mesh.active.begin(), mesh.active.end(), 1), 9);
    EXPECT_EQ(activate_misfits(mesh, {0.5, 2, 1e9}), 0);
    EXPECT_EQ(activate_misfits(mesh, {0.5, 2, 4}), 8) << "by shape";
  }
}

TEST(MisfitMending, brings_a_node_back_to_where_its_edges_fit) {
  for (const double stretch : {1.0, 0.01}) {
    PlaneMesh plane = honeycomb({0.95, 0.6});
    for (Vec2& p : plane.points) p.y *= stretch;
    const auto metrics = plane_test::constant_metrics(plane, {1, 0, 1 / (stretch * stretch)});
    MetricMesh mesh = plane_test::metric_mesh(plane, metrics);
    const MetricField field = plane_test::field_of(plane, metrics);
    const double before = worst_energy_of(mesh);
    EXPECT_GT(activate_misfits(mesh, {}), 0);
    EXPECT_EQ(mend_misfits(mesh, field, {}), 1);
    EXPECT_THAT(validate(mesh), IsEmpty());
    EXPECT_LT(worst_energy_of(mesh), before);
    EXPECT_EQ(activate_misfits(mesh, {}), 0);
    EXPECT_NEAR(mesh.complex.point(5).x, right_place.x, 0.06);
    EXPECT_NEAR(mesh.complex.point(5).y, right_place.y * stretch, 0.06 * stretch);
  }
}

TEST(MisfitMending, moves_no_node_of_the_border) {
  PlaneMesh plane = plane_test::square(6);
  plane.points[at(plane.triangles[30][0])].x += 0.08;
  const auto metrics = plane_test::constant_metrics(plane, plane_test::round_metric(0.2));
  MetricMesh mesh = plane_test::metric_mesh(plane, metrics);
  const MetricField field = plane_test::field_of(plane, metrics);
  mend_misfits(mesh, field, {});
  EXPECT_THAT(validate(mesh), IsEmpty());
  for (std::int32_t v = 0; v < mesh.nodes(); ++v) {
    if (mesh.is_inside(v)) continue;
    EXPECT_EQ(mesh.complex.point(v), plane.points[at(v)]);
  }
}

}  // namespace
}  // namespace tetfarm
