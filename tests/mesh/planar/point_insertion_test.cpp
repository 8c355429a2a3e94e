#include "mesh/planar/point_insertion.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "mesh/planar/constrained_delaunay.h"
#include "mesh/planar/edge_flips.h"
#include "tests/mesh/planar/regions.h"

namespace tetfarm {
namespace {

using planar_test::add_loop;
using planar_test::circle_loop;
using planar_test::rectangle;
using ::testing::IsEmpty;

constexpr std::int64_t plenty = 1'000'000;

TriangleComplex triangulated(const PlanarRegion& region) {
  return constrained_delaunay(region).complex;
}

bool is_delaunay(const TriangleComplex& complex) {
  for (std::int32_t t = 0; t < complex.size(); ++t)
    for (int i = 0; i < 3; ++i)
      if (!is_locally_delaunay(complex, edge_handle(t, i))) return false;
  return true;
}

double distance(const Vec2& a, const Vec2& b) { return std::hypot(a.x - b.x, a.y - b.y); }

TEST(PointInsertion, keeps_the_triangulation_constrained_delaunay) {
  PlanarRegion region = rectangle({0, 0}, {1, 1}, 12);
  add_loop(region, circle_loop({0.5, 0.5}, -0.2, 15));
  TriangleComplex complex = triangulated(region);
  ASSERT_TRUE(insert_points(
      complex, [](const Vec2&) { return 0.08; }, plenty));
  EXPECT_THAT(validate(complex), IsEmpty());
  EXPECT_TRUE(is_delaunay(complex));
}

TEST(PointInsertion, keeps_points_apart_and_leaves_no_large_hole) {
  constexpr double h = 0.05;
  TriangleComplex complex = triangulated(rectangle({0, 0}, {1, 1}, 20));
  ASSERT_TRUE(insert_points(
      complex, [](const Vec2&) { return h; }, plenty));
  for (std::int32_t t = 0; t < complex.size(); ++t)
    for (int i = 0; i < 3; ++i) {
      const double length = distance(complex.point(complex.node(t, next(i))),
                                     complex.point(complex.node(t, previous(i))));
      EXPECT_GT(length, 0.64 * h);
      EXPECT_LT(length, 2 * 0.78 * h);
    }
}

TEST(PointInsertion, keeps_points_apart_and_off_the_boundary_in_sharp_places) {
  constexpr double h = 0.1;
  for (int spikes = 3; spikes < 12; ++spikes) {
    std::vector<Vec2> star = circle_loop({0, 0}, 1, 2 * spikes);
    for (std::size_t i = 0; i < star.size(); i += 2) star[i] = {3 * star[i].x, 3 * star[i].y};
    PlanarRegion region;
    add_loop(region, star);
    TriangleComplex complex = triangulated(region);
    ASSERT_TRUE(insert_points(
        complex, [](const Vec2&) { return h; }, plenty));
    const auto first_inner = static_cast<std::int32_t>(region.points.size());
    for (std::int32_t t = 0; t < complex.size(); ++t)
      for (int i = 0; i < 3; ++i) {
        const std::int32_t a = complex.node(t, next(i));
        const std::int32_t b = complex.node(t, previous(i));
        const Vec2& pa = complex.point(a);
        const Vec2& pb = complex.point(b);
        if (std::max(a, b) >= first_inner) {
          EXPECT_GT(distance(pa, pb), 0.64 * h);
        } else if (complex.is_constrained(t, i) && complex.node(t, i) >= first_inner) {
          const Vec2& apex = complex.point(complex.node(t, i));
          const double height =
              ((pb.x - pa.x) * (apex.y - pa.y) - (pb.y - pa.y) * (apex.x - pa.x)) /
              distance(pa, pb);
          EXPECT_GT(height, 0.49 * h);
          EXPECT_GT(height, 0.19 * distance(pa, pb));
        }
      }
  }
}

TEST(PointInsertion, keeps_points_half_the_spacing_off_edges_that_are_a_bit_too_long) {
  constexpr double h = 0.1;
  for (int sides = 4; sides < 40; ++sides) {
    PlanarRegion region;  // edges of 1.4 to 2.2 h
    const double edge = (1.4 + 0.02 * sides) * h;
    add_loop(region, circle_loop({0, 0}, edge * sides / (2 * std::numbers::pi), sides));
    TriangleComplex complex = triangulated(region);
    ASSERT_TRUE(insert_points(
        complex, [](const Vec2&) { return h; }, plenty));
    for (std::int32_t v = 0; v < sides; ++v) {
      const EdgeHandle side = complex.find_edge(v, (v + 1) % sides);
      const std::int32_t apex = complex.node(triangle_of(side), edge_of(side));
      const Vec2& pa = complex.point(v);
      const Vec2& pb = complex.point((v + 1) % sides);
      const Vec2& p = complex.point(apex);
      const double height =
          ((pb.x - pa.x) * (p.y - pa.y) - (pb.y - pa.y) * (p.x - pa.x)) / distance(pa, pb);
      if (apex >= sides) {
        EXPECT_GT(height, 0.49 * h);
      }
    }
  }
}

TEST(PointInsertion, leaves_a_region_alone_that_is_smaller_than_the_spacing) {
  TriangleComplex complex = triangulated(rectangle({0, 0}, {1, 1}, 1));
  ASSERT_TRUE(insert_points(
      complex, [](const Vec2&) { return 100.0; }, plenty));
  EXPECT_EQ(complex.points.size(), 4U);
}

TEST(PointInsertion, follows_a_spacing_that_is_small_in_the_middle_only) {
  const auto spacing = [](const Vec2& p) {
    return std::min(0.1, 0.01 + 0.2 * distance(p, {0.5, 0.5}));
  };
  TriangleComplex complex = triangulated(rectangle({0, 0}, {1, 1}, 10));
  ASSERT_TRUE(insert_points(complex, spacing, plenty));
  const double nearest = distance(*std::ranges::min_element(complex.points, {},
                                                            [](const Vec2& p) {
                                                              return distance(p, {0.5, 0.5});
                                                            }),
                                  {0.5, 0.5});
  EXPECT_LT(nearest, 0.012);
}

TEST(PointInsertion, fills_a_square_whose_edges_are_far_longer_than_the_spacing) {
  TriangleComplex complex = triangulated(rectangle({0, 0}, {1, 1}, 1));
  ASSERT_TRUE(insert_points(
      complex, [](const Vec2&) { return 0.05; }, plenty));
  EXPECT_GT(complex.points.size(), 150U);
  EXPECT_THAT(validate(complex), IsEmpty());
}

TEST(PointInsertion, fans_out_from_short_edges_without_needles) {
  TriangleComplex complex = triangulated(rectangle({0, 0}, {1, 1}, 80));
  ASSERT_TRUE(insert_points(
      complex, [](const Vec2&) { return 0.2; }, plenty));
  for (const auto& [a, b, c] : complex.triangles) {
    const double ab = distance(complex.point(a), complex.point(b));
    const double bc = distance(complex.point(b), complex.point(c));
    const double ca = distance(complex.point(c), complex.point(a));
    EXPECT_GT(std::min({ab, bc, ca}), 0.25 * std::max({ab, bc, ca}));
  }
}

TEST(PointInsertion, stops_when_there_are_too_many_triangles) {
  TriangleComplex complex = triangulated(rectangle({0, 0}, {1, 1}, 20));
  EXPECT_FALSE(insert_points(
      complex, [](const Vec2&) { return 0.05; }, 300));
}

TEST(PointInsertion, ends_when_the_spacing_is_not_a_number) {
  TriangleComplex complex = triangulated(rectangle({0, 0}, {1, 1}, 4));
  EXPECT_TRUE(insert_points(
      complex, [](const Vec2&) { return std::numeric_limits<double>::quiet_NaN(); }, plenty));
}

TEST(PointInsertion, estimates_the_triangles_of_a_uniform_spacing) {
  TriangleComplex complex = triangulated(rectangle({0, 0}, {1, 1}, 20));
  const auto spacing = [](const Vec2&) { return 0.05; };
  const double estimate = estimated_triangles(complex, spacing);
  ASSERT_TRUE(insert_points(complex, spacing, plenty));
  EXPECT_NEAR(static_cast<double>(complex.size()) / estimate, 1, 0.1);
}

}  // namespace
}  // namespace tetfarm
