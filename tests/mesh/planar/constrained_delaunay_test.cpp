#include "mesh/planar/constrained_delaunay.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "tests/mesh/planar/regions.h"

namespace tetfarm {
namespace {

using planar_test::add_loop;
using planar_test::circle_loop;
using planar_test::rectangle;
using planar_test::rectangle_loop;
using planar_test::whats_wrong;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::UnorderedElementsAre;

std::vector<std::string> wrong_with(const PlanarRegion& region) {
  const ConstrainedDelaunay delaunay = constrained_delaunay(region);
  if (delaunay.failure) return {delaunay.failure->reason};
  std::vector<std::string> wrong = validate(delaunay.complex);
  const std::vector<std::string> more =
      whats_wrong(region, {delaunay.complex.points, delaunay.complex.triangles});
  wrong.insert(wrong.end(), more.begin(), more.end());
  return wrong;
}

PlanarFailure failure_of(const PlanarRegion& region) {
  const ConstrainedDelaunay delaunay = constrained_delaunay(region);
  return delaunay.failure.value_or(PlanarFailure{"no failure", {}});
}

/// A star-shaped polygon with spikes of random length.
std::vector<Vec2> star_loop(int n, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::vector<Vec2> loop = circle_loop({0, 0}, 1, n);
  for (Vec2& p : loop) {
    const double stretch = 0.05 + static_cast<double>(random()) / 4294967296.0;
    p = {p.x * stretch, p.y * stretch};
  }
  return loop;
}

std::vector<Vec2> comb_loop(int teeth, double gap) {
  std::vector<Vec2> loop{{0, 0}, {static_cast<double>(teeth), 0}};
  for (int i = teeth; i > 0; --i) {
    loop.push_back({static_cast<double>(i), 10});
    loop.push_back({i - 1 + gap, 10});
    loop.push_back({i - 1 + gap, 1});
    if (i > 1) loop.push_back({static_cast<double>(i) - 1, 1});
  }
  loop.back() = {gap, 1};
  loop.push_back({0, 1});
  return loop;
}

TEST(ConstrainedDelaunay, has_n_minus_two_triangles_in_a_simple_polygon) {
  for (std::uint32_t seed = 1; seed <= 60; ++seed) {
    const int n = 5 + static_cast<int>(seed) * 3;
    PlanarRegion region;
    add_loop(region, star_loop(n, seed));
    SCOPED_TRACE(seed);
    EXPECT_THAT(wrong_with(region), IsEmpty());
    EXPECT_EQ(constrained_delaunay(region).complex.size(), n - 2);
  }
}

TEST(ConstrainedDelaunay, survives_the_degeneracies_of_a_subdivided_square) {
  for (const int n : {1, 2, 3, 8, 40}) {
    SCOPED_TRACE(n);
    EXPECT_THAT(wrong_with(rectangle({0, 0}, {1, 1}, n)), IsEmpty());
  }
}

TEST(ConstrainedDelaunay, survives_a_thousand_points_near_a_circle) {
  PlanarRegion region;
  add_loop(region, circle_loop({0, 0}, 1, 1000));
  EXPECT_THAT(wrong_with(region), IsEmpty());
}

TEST(ConstrainedDelaunay, recovers_the_edges_of_a_comb_with_narrow_teeth) {
  for (const double gap : {0.5, 0.05, 0.999}) {
    PlanarRegion region;
    add_loop(region, comb_loop(12, gap));
    EXPECT_THAT(wrong_with(region), IsEmpty());
  }
}

TEST(ConstrainedDelaunay, recovers_an_edge_across_many_others) {
  // Two rows of points between the ends of long edges that no Delaunay triangulation has.
  PlanarRegion region;
  std::vector<Vec2> loop{{-100, 0}, {100, 0}};
  for (int i = 40; i >= -40; --i) loop.push_back({static_cast<double>(i), i % 2 == 0 ? 0.01 : 3});
  add_loop(region, loop);
  loop = {{100, -0.5}, {-100, -0.5}};
  for (int i = -40; i <= 40; ++i) loop.push_back({static_cast<double>(i), i % 2 == 0 ? -0.51 : -3});
  add_loop(region, loop);
  EXPECT_THAT(wrong_with(region), IsEmpty());
}

TEST(ConstrainedDelaunay, keeps_holes_islands_and_several_outer_loops) {
  PlanarRegion region = rectangle({0, 0}, {10, 10}, 4);
  std::vector<Vec2> hole = rectangle_loop({2, 2}, {8, 8}, 3);
  std::reverse(hole.begin(), hole.end());
  add_loop(region, hole);
  add_loop(region, rectangle_loop({4, 4}, {6, 6}, 2));
  add_loop(region, rectangle_loop({20, 0}, {25, 5}, 5));
  EXPECT_THAT(wrong_with(region), IsEmpty());
}

TEST(ConstrainedDelaunay, satisfies_euler_with_holes) {
  PlanarRegion region = rectangle({0, 0}, {10, 10}, 6);
  add_loop(region, circle_loop({3, 3}, -1, 7));
  add_loop(region, circle_loop({7, 6}, -2, 12));
  const TriangleComplex complex = constrained_delaunay(region).complex;
  const auto v = static_cast<std::int32_t>(region.points.size());
  const auto border = static_cast<std::int32_t>(region.edges.size());
  const std::int32_t edges = (3 * complex.size() + border) / 2;
  EXPECT_EQ(v - edges + complex.size(), 1 - 2);
}

TEST(ConstrainedDelaunay, lets_two_loops_touch_in_a_vertex) {
  PlanarRegion outside;  // two squares corner to corner
  outside.points = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {2, 1}, {2, 2}, {1, 2}};
  outside.edges = {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {2, 4}, {4, 5}, {5, 6}, {6, 2}};
  EXPECT_THAT(wrong_with(outside), IsEmpty());

  PlanarRegion inside = rectangle({0, 0}, {4, 4}, 2);  // a hole that hangs on a boundary point
  inside.points.insert(inside.points.end(), {{1.5, 1}, {2.5, 1}});
  inside.edges.insert(inside.edges.end(), {{1, 8}, {8, 9}, {9, 1}});
  EXPECT_THAT(wrong_with(inside), IsEmpty());
}

TEST(ConstrainedDelaunay, works_at_every_scale_and_place) {
  struct Place {
    double scale, shift;
  };
  for (const auto& [scale, shift] : {Place{1e-6, 0}, Place{1e6, 0}, Place{1, 1e6}, Place{1e6, 1e6},
                                     Place{1, -12345.678}, Place{1e-3, 1e6}, Place{1e-6, 1}}) {
    PlanarRegion region = rectangle({0, 0}, {1, 1}, 7);
    add_loop(region, circle_loop({0.5, 0.5}, -0.2, 9));
    for (Vec2& p : region.points) p = {p.x * scale + shift, p.y * scale - shift};
    SCOPED_TRACE(scale);
    SCOPED_TRACE(shift);
    EXPECT_THAT(wrong_with(region), IsEmpty());
  }
}

TEST(ConstrainedDelaunay, does_not_depend_on_the_order_of_the_edges) {
  PlanarRegion region = rectangle({0, 0}, {10, 10}, 9);
  add_loop(region, circle_loop({5, 5}, -3, 24));
  const TriangleComplex first = constrained_delaunay(region).complex;
  std::mt19937 random(7);
  for (int round = 0; round < 5; ++round) {
    std::shuffle(region.edges.begin(), region.edges.end(), random);
    const TriangleComplex again = constrained_delaunay(region).complex;
    EXPECT_EQ(again.triangles, first.triangles);
    EXPECT_EQ(again.neighbours, first.neighbours);
  }
}

TEST(ConstrainedDelaunay, keeps_a_point_without_edges_that_lies_inside) {
  PlanarRegion region = rectangle({0, 0}, {1, 1}, 2);
  region.points.push_back({0.3, 0.4});
  region.points.push_back({3, 4});
  EXPECT_THAT(wrong_with(region), IsEmpty());
  const TriangleComplex complex = constrained_delaunay(region).complex;
  EXPECT_GE(complex.node2triangle[8], 0);
  EXPECT_EQ(complex.node2triangle[9], -1);
}

TEST(ConstrainedDelaunay, refuses_crossing_edges_and_names_all_places) {
  PlanarRegion region;
  add_loop(region, {{0, 0}, {6, 0}, {6, 2}, {0, 2}});
  add_loop(region, {{2, -1}, {4, -1}, {4, 1}, {2, 1}});
  const PlanarFailure failure = failure_of(region);
  EXPECT_EQ(failure.reason, "two edges cross");
  EXPECT_THAT(failure.where, UnorderedElementsAre(Vec2{2, 0}, Vec2{4, 0}));
}

TEST(ConstrainedDelaunay, refuses_a_point_on_an_edge) {
  PlanarRegion region;
  add_loop(region, {{0, 0}, {4, 0}, {4, 4}, {0, 4}});
  add_loop(region, {{2, 0}, {3, 1}, {1, 1}});
  const PlanarFailure failure = failure_of(region);
  EXPECT_EQ(failure.reason, "a point lies on an edge");
  EXPECT_THAT(failure.where, ElementsAre(Vec2{2, 0}));
}

TEST(ConstrainedDelaunay, refuses_two_points_at_one_place) {
  PlanarRegion region;
  add_loop(region, {{0, 0}, {4, 0}, {4, 4}});
  add_loop(region, {{4, 0}, {8, 0}, {8, 4}});
  const PlanarFailure failure = failure_of(region);
  EXPECT_EQ(failure.reason, "two points coincide");
  EXPECT_THAT(failure.where, ElementsAre(Vec2{4, 0}));
}

TEST(ConstrainedDelaunay, refuses_loops_that_run_the_wrong_way) {
  PlanarRegion region;
  add_loop(region, circle_loop({0, 0}, -1, 12));
  EXPECT_EQ(failure_of(region).reason, "the outermost loop runs clockwise");

  region = rectangle({0, 0}, {4, 4}, 1);
  add_loop(region, rectangle_loop({1, 1}, {2, 2}, 1));
  EXPECT_EQ(failure_of(region).reason, "loops disagree about which side is inside");
}

TEST(ConstrainedDelaunay, refuses_edges_that_make_no_region) {
  EXPECT_EQ(failure_of({}).reason, "the region has no edges");
  PlanarRegion region = rectangle({0, 0}, {1, 1}, 1);
  region.edges.push_back({0, 7});
  EXPECT_EQ(failure_of(region).reason, "an edge names a point that does not exist");
  region = rectangle({0, 0}, {1, 1}, 1);
  region.edges.push_back({2, 2});
  EXPECT_EQ(failure_of(region).reason, "an edge begins and ends at the same point");
  region = rectangle({0, 0}, {1, 1}, 1);
  region.edges.insert(region.edges.end(), {{0, 2}, {2, 0}});
  EXPECT_EQ(failure_of(region).reason, "an edge is used twice");
  region = rectangle({0, 0}, {1, 1}, 1);
  region.points[3].y = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(failure_of(region).reason, "a coordinate is not finite");
}

TEST(ConstrainedDelaunay, refuses_points_on_one_line) {
  PlanarRegion region;
  add_loop(region, {{0, 0}, {1, 0}, {2, 0}});
  EXPECT_EQ(failure_of(region).reason, "a point lies on an edge");
}

}  // namespace
}  // namespace tetfarm
