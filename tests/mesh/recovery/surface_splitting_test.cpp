#include "mesh/recovery/surface_splitting.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <set>

#include "mesh/core/validate.h"
#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

TEST(SurfaceSplitting, of_an_edge_and_a_face_keeps_the_surface_closed_and_knows_the_source) {
  const SurfaceMesh cube = shapes::unit_cube();
  SplitSurface surface = unsplit(cube.triangles);
  const auto [a, b, c] = cube.triangles[0];
  split_edge(surface, a, b, 100);
  EXPECT_EQ(surface.triangles.size(), cube.triangles.size() + 2);
  EXPECT_EQ(surface.splits.front().sources.size(), 2U);
  split_face(surface, 5, 101);
  EXPECT_EQ(surface.triangles.size(), cube.triangles.size() + 4);
  EXPECT_TRUE(unmatched_edges(surface.triangles).empty());
  EXPECT_EQ(surface.source.size(), surface.triangles.size());
  EXPECT_EQ(surface.source.back(), 5);
}

TEST(SurfaceSplitting, swaps_edges_inside_one_boundary_triangle_only) {
  const SurfaceMesh cube = shapes::unit_cube();
  SplitSurface surface = unsplit(cube.triangles);
  const auto [a, b, c] = cube.triangles[0];
  EXPECT_FALSE(opposite_corners(surface, a, b).has_value());
  split_face(surface, 0, 100);
  split_edge(surface, a, b, 101);
  const auto corners = opposite_corners(surface, a, 100);
  ASSERT_TRUE(corners.has_value());
  EXPECT_EQ(std::set<std::int32_t>(corners->begin(), corners->end()), (std::set{101, c}));
  swap_edge(surface, a, 100);
  EXPECT_TRUE(unmatched_edges(surface.triangles).empty());
  EXPECT_FALSE(opposite_corners(surface, a, 100).has_value());
  EXPECT_TRUE(opposite_corners(surface, c, 101).has_value());
  replace_fan(surface, 100, {{{101, b, c}, 0}});
  EXPECT_TRUE(unmatched_edges(surface.triangles).empty());
}

Vec3 doubled_area(const std::vector<Vec3>& points, const Triangle& t) {
  const auto p = [&](std::size_t i) { return points[static_cast<std::size_t>(t[i])]; };
  return cross(p(1) - p(0), p(2) - p(0));
}

TEST(SurfaceSplitting, by_chance_leaves_each_boundary_triangle_its_area_and_the_surface_closed) {
  const SurfaceMesh cube = shapes::box({0, 0, 0}, {1, 2, 3}, 2);
  std::vector<Vec3> points = cube.vertices;
  SplitSurface surface = unsplit(cube.triangles);
  std::mt19937 random(6);
  int swaps = 0;
  for (int step = 0; step < 300; ++step) {
    const auto i = static_cast<std::int32_t>(random() % surface.triangles.size());
    const auto [a, b, c] = surface.triangles[static_cast<std::size_t>(i)];
    const auto place = [&](std::int32_t v) { return points[static_cast<std::size_t>(v)]; };
    const auto node = static_cast<std::int32_t>(points.size());
    const std::size_t triangles = surface.triangles.size();
    if (step % 3 == 0) {
      points.push_back(0.5 * (place(a) + place(b)));
      const auto sources = sources_at(surface, a, b);
      split_edge(surface, a, b, node);
      EXPECT_EQ(surface.triangles.size(), triangles + 2);
      EXPECT_EQ(surface.splits.back().sources, sources);
    } else if (step % 3 == 1) {
      points.push_back((place(a) + place(b) + place(c)) / 3);
      split_face(surface, i, node);
      EXPECT_EQ(surface.triangles.size(), triangles + 2);
    } else if (const auto corners = opposite_corners(surface, a, b)) {
      const Vec3 normal = doubled_area(points, surface.triangles[static_cast<std::size_t>(i)]);
      const Vec3 across = place((*corners)[1]) - place((*corners)[0]);
      // Both ends of the edge lie on different sides of the other diagonal.
      const double side_of_a = dot(cross(across, place(a) - place((*corners)[0])), normal);
      const double side_of_b = dot(cross(across, place(b) - place((*corners)[0])), normal);
      if (side_of_a * side_of_b > -1e-12) continue;
      swap_edge(surface, a, b);
      EXPECT_TRUE(sources_at(surface, a, b).empty());
      EXPECT_EQ(sources_at(surface, (*corners)[0], (*corners)[1]).size(), 2U);
      ++swaps;
    }
  }
  EXPECT_GT(swaps, 20);
  EXPECT_TRUE(unmatched_edges(surface.triangles).empty());
  std::vector<Vec3> areas(cube.triangles.size());
  for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
    const auto source = static_cast<std::size_t>(surface.source[i]);
    const Vec3 area = doubled_area(points, surface.triangles[i]);
    EXPECT_GT(dot(area, doubled_area(points, cube.triangles[source])), 0);
    areas[source] += area;
  }
  for (std::size_t i = 0; i < areas.size(); ++i) {
    EXPECT_NEAR(norm(areas[i] - doubled_area(points, cube.triangles[i])), 0, 1e-12);
  }
}

}  // namespace
}  // namespace tetfarm
