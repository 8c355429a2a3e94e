#include "mesh/recovery/surface_fans.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "tests/mesh/recovery/split_cube.h"
#include "tests/support/chance.h"

namespace tetfarm {
namespace {

TEST(SurfaceFans, of_a_point_on_an_edge_are_two_whose_places_the_whole_triangles_fill) {
  SplitCube cube(2, true);
  const auto fans = surface_fans(*cube.mesh, cube.surface, cube.domain.triangles, cube.node);
  ASSERT_TRUE(fans.has_value());
  ASSERT_EQ(fans->size(), 2U);
  for (const SurfaceFan& fan : *fans) {
    ASSERT_EQ(fan.without.size(), 1U);
    Triangle whole = cube.domain.triangles[static_cast<std::size_t>(fan.source)];
    Triangle cut = fan.without.front();
    std::rotate(whole.begin(), std::min_element(whole.begin(), whole.end()), whole.end());
    std::rotate(cut.begin(), std::min_element(cut.begin(), cut.end()), cut.end());
    EXPECT_EQ(cut, whole);
  }
}

TEST(SurfaceFans, of_a_point_in_a_crooked_polygon_are_filled_by_ears_without_it) {
  shapes::Chance chance(4);
  for (int round = 0; round < 50; ++round) {
    const int corners = chance.pick(3, 12);
    // In the plane x + y + z = 1, round its middle.
    const Vec3 u = normalized(Vec3{1, -1, 0});
    const Vec3 v = normalized(Vec3{1, 1, -2});
    TetComplex complex;
    complex.points = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1.0 / 3, 1.0 / 3, 1.0 / 3}};
    const Triangle whole = {0, 1, 2};
    const bool is_turned = dot(cross(u, v), Vec3{1, 1, 1}) < 0;
    SplitSurface surface;
    for (std::int32_t i = 0; i < corners; ++i) {
      const double angle = 2 * std::numbers::pi * (is_turned ? -i : i) / corners;
      const double radius = chance.between(0.05, 0.3);
      complex.points.push_back(complex.points[3] +
                               radius * (std::cos(angle) * u + std::sin(angle) * v));
      surface.triangles.push_back({3, 4 + i, 4 + (i + 1) % corners});
      surface.source.push_back(0);
    }
    std::vector<std::uint8_t> constrained;
    const LocalRemeshing mesh(complex, constrained);
    const auto found = surface_fans(mesh, surface, {whole}, 3);
    ASSERT_TRUE(found.has_value());
    ASSERT_EQ(found->size(), 1U);
    const SurfaceFan& fan = found->front();
    EXPECT_EQ(fan.source, 0);
    EXPECT_EQ(std::ssize(fan.edges), corners);
    ASSERT_EQ(std::ssize(fan.without), corners - 2);
    const auto area = [&](const Triangle& t) {
      const auto p = [&](std::size_t i) { return complex.points[static_cast<std::size_t>(t[i])]; };
      return dot(cross(p(1) - p(0), p(2) - p(0)), normalized(Vec3{1, 1, 1}));
    };
    double with = 0;
    double without = 0;
    for (const Triangle& t : surface.triangles) with += area(t);
    std::map<std::pair<std::int32_t, std::int32_t>, int> edges;
    for (const Triangle& t : fan.without) {
      EXPECT_GT(area(t), 0);
      EXPECT_EQ(std::count(t.begin(), t.end(), 3), 0);
      without += area(t);
      for (std::size_t k = 0; k < 3; ++k) ++edges[{t[k], t[(k + 1) % 3]}];
    }
    EXPECT_NEAR(with, without, 1e-14);
    for (const auto& edge : fan.edges) EXPECT_EQ(edges[edge], 1);
  }
}

TEST(SurfaceFans, are_filled_by_no_ear_that_is_cut_off_along_a_corner) {
  // The corner (1, 1) lies between the neighbours of the first one.
  TetComplex complex;
  complex.points = {{-5, -5, 0}, {9, -5, 0}, {0, 9, 0}, {1.5, 0.75, 0},
                    {2, 0, 0},   {2, 2, 0},  {1, 1, 0}, {0, 0, 0}};
  SplitSurface surface;
  surface.triangles = {{3, 4, 5}, {3, 5, 6}, {3, 6, 7}, {3, 7, 4}};
  surface.source = {0, 0, 0, 0};
  std::vector<std::uint8_t> constrained;
  const LocalRemeshing mesh(complex, constrained);
  const auto fans = surface_fans(mesh, surface, {{0, 1, 2}}, 3);
  ASSERT_TRUE(fans.has_value());
  ASSERT_EQ(fans->size(), 1U);
  ASSERT_EQ(fans->front().without.size(), 2U);
  for (const auto& [a, b, c] : fans->front().without) {
    const auto p = [&](std::int32_t v) { return complex.points[static_cast<std::size_t>(v)]; };
    EXPECT_GT(cross(p(b) - p(a), p(c) - p(a)).z, 0);
  }
}

TEST(SurfaceFans, of_a_node_that_the_surface_does_not_have_are_none) {
  const SplitCube cube(2, true);
  const auto fans = surface_fans(*cube.mesh, cube.surface, cube.domain.triangles, cube.node + 1);
  ASSERT_TRUE(fans.has_value());
  EXPECT_TRUE(fans->empty());
}

}  // namespace
}  // namespace tetfarm
