#include "mesh/render/plane_section.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "tests/support/hybrid_mesh.h"

namespace tetfarm {
namespace {

double area_of(const CellSection& section) {
  Vec3 sum;
  for (std::size_t i = 1; i + 1 < section.corners.size(); ++i) {
    sum +=
        cross(section.corners[i] - section.corners[0], section.corners[i + 1] - section.corners[0]);
  }
  return 0.5 * norm(sum);
}

double area_of_sections(const HybridMesh& mesh, const Vec3& normal, double at) {
  double area = 0;
  for (const NumberedPart& part : mesh.parts) {
    for (const CellSection& section : plane_section(part, normal, at)) area += area_of(section);
  }
  return area;
}

TEST(PlaneSection, areas_of_all_parallel_planes_come_to_the_volume) {
  const HybridMesh mesh;
  for (const Vec3& normal : {Vec3{0, 0, 1}, Vec3{1, 0, 0}, normalized(Vec3{1, 2, -3})}) {
    constexpr int planes = 4000;
    constexpr double reach = 4;
    double volume = 0;
    for (int i = 0; i < planes; ++i) {
      const double at = reach * ((2 * i + 1.0) / planes - 1);
      volume += area_of_sections(mesh, normal, at) * 2 * reach / planes;
    }
    EXPECT_NEAR(volume, HybridMesh::volume, 1e-4);
  }
}

TEST(PlaneSection, lies_in_the_plane_and_within_the_edges_of_its_cell) {
  const HybridMesh mesh;
  const Vec3 normal = normalized(Vec3{1, 1, 2});
  for (const NumberedPart& part : mesh.parts) {
    for (const CellSection& section : plane_section(part, normal, 0.7)) {
      EXPECT_GE(section.corners.size(), 3);
      for (const Vec3& p : section.corners) EXPECT_NEAR(dot(normal, p), 0.7, 1e-12);
    }
  }
}

TEST(PlaneSection, of_a_hex_along_its_sides_is_a_square_and_askew_a_hexagon) {
  const NumberedPart part = HybridMesh().parts[0];  // a prism above two hexes
  const auto corners_of = [&](const Vec3& normal, double at) {
    std::set<std::size_t> counts;
    for (const CellSection& section : plane_section(part, normal, at)) {
      counts.insert(section.corners.size());
    }
    return counts;
  };
  EXPECT_EQ(corners_of({0, 0, 1}, 0.5), std::set<std::size_t>{4});
  EXPECT_EQ(corners_of({1, 1, 1}, 1.5).count(6), 1);
}

TEST(PlaneSection, of_a_plane_in_which_a_face_lies_is_the_cell_below_it_alone) {
  const NumberedPart part = HybridMesh().parts[0];
  std::vector<std::int64_t> cells;
  for (const CellSection& section : plane_section(part, {0, 0, 1}, 0)) {
    cells.push_back(section.cell);
    EXPECT_DOUBLE_EQ(area_of(section), 1);
  }
  EXPECT_EQ(cells.size(), 1);
  EXPECT_TRUE(plane_section(part, {0, 0, 1}, -1).empty()) << "it only touches the lowest cells";
}

TEST(PlaneSection, has_the_same_points_in_two_cells_that_share_an_edge) {
  const NumberedPart part = HybridMesh().parts[0];
  std::set<std::array<double, 3>> points;
  std::size_t corners = 0;
  for (const CellSection& section : plane_section(part, normalized({1, 2, 7}), 0.3)) {
    corners += section.corners.size();
    for (const Vec3& p : section.corners) points.insert({p.x, p.y, p.z});
  }
  EXPECT_LT(points.size(), corners);
  for (const auto& p : points) {
    for (const auto& q : points) {
      const double apart = std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
      EXPECT_TRUE(p == q || apart > 1e-9);
    }
  }
}

}  // namespace
}  // namespace tetfarm
