#include "mesh/inspect/surface_figures.h"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "tests/mesh/inspect/check_support.h"
#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

SurfaceReport measure(const SurfaceMesh& mesh) {
  SurfaceReport report;
  measure_surface(mesh, edge_uses(mesh.triangles, std::vector<char>(mesh.triangles.size(), 1)),
                  report);
  return report;
}

TEST(SurfaceFigures, of_a_cube_are_known) {
  SurfaceMesh mesh = shapes::unit_cube();
  mesh.vertices.push_back({5, 5, 5});
  const SurfaceReport report = measure(mesh);
  EXPECT_DOUBLE_EQ(report.shortest_edge, 1);
  EXPECT_DOUBLE_EQ(report.median_edge, 1);  // 12 edges and 6 diagonals
  EXPECT_DOUBLE_EQ(report.longest_edge, std::sqrt(2.0));
  EXPECT_NEAR(report.smallest_angle_deg, 45, 1e-9);
  EXPECT_EQ(report.unused_vertices, 1);
}

TEST(SurfaceFigures, resolve_tiny_angles) {
  SurfaceMesh mesh = shapes::tetrahedron();
  mesh.vertices[3] = {0, 0, 1e-10};
  EXPECT_NEAR(measure(mesh).smallest_angle_deg, 1e-10 * 180 / std::numbers::pi, 1e-15);
}

TEST(SurfaceFigures, count_no_vertex_as_unused_whose_triangle_is_not_measured) {
  SurfaceMesh mesh = shapes::unit_cube();
  mesh.vertices.push_back({5, 5, 5});
  mesh.triangles.push_back({0, 8, 8});
  std::vector<char> is_measured(mesh.triangles.size(), 1);
  is_measured.back() = 0;
  SurfaceReport report;
  measure_surface(mesh, edge_uses(mesh.triangles, is_measured), report);
  EXPECT_EQ(report.unused_vertices, 0);
  EXPECT_DOUBLE_EQ(report.longest_edge, std::sqrt(2.0));
}

TEST(SurfaceFigures, of_nothing_are_zero) {
  const SurfaceReport report = measure({});
  EXPECT_EQ(report.longest_edge, 0);
  EXPECT_EQ(report.smallest_angle_deg, 0);
}

}  // namespace
}  // namespace tetfarm
