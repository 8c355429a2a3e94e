#include "mesh/spacing/sources.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace tetfarm {
namespace {

const SourceCorner corner_at_origin{{0, 0, 0}, 0.1, 1, 3};

TEST(SourceLaw, is_constant_inside_the_inner_radius) {
  EXPECT_EQ(source_law(corner_at_origin, 0, 0.4, 10), 0.1);
  EXPECT_EQ(source_law(corner_at_origin, 1, 0.4, 10), 0.1);
}

TEST(SourceLaw, decays_exponentially_to_the_background) {
  EXPECT_NEAR(source_law(corner_at_origin, 2, 0.4, 10), 0.2, 1e-14);
  EXPECT_NEAR(source_law(corner_at_origin, 3, 0.4, 10), 0.4, 1e-14);
}

TEST(SourceLaw, doubles_at_the_outer_radius_without_a_background) {
  EXPECT_NEAR(source_law(corner_at_origin, 3, 0, 10), 0.2, 1e-14);
}

TEST(SourceLaw, decays_up_to_the_outer_radius_and_grows_as_it_may_beyond) {
  EXPECT_NEAR(source_law(corner_at_origin, 3.5, 0.4, 10), 0.4 + 0.5 * 10, 1e-12);
  EXPECT_NEAR(source_law(corner_at_origin, 3.5, 0.4, 0.2),
              source_law(corner_at_origin, 3, 0.4, 0.2) + 0.1, 1e-12);
}

TEST(SourceLaw, does_not_shrink_to_a_finer_background) {
  EXPECT_EQ(source_law(corner_at_origin, 2, 0.05, 10), 0.1);
}

TEST(SourceLaw, grows_no_faster_than_allowed) {
  for (const double growth : {0.02, 0.1, 0.3}) {
    for (const double background : {0.0, 0.4, 50.0}) {
      double before = 0.1;
      for (double r = 0; r < 10; r += 0.01) {
        const double now = source_law(corner_at_origin, r, background, growth);
        EXPECT_GE(now, before);
        EXPECT_LE(now - before, growth * 0.01 + 1e-12);
        before = now;
      }
    }
  }
}

TEST(SourceLaw, jumps_to_growth_when_the_radii_are_equal) {
  EXPECT_NEAR(source_law({{}, 0.1, 1, 1}, 2, 5, 0.3), 0.4, 1e-14);
}

const Source line{{{{0, 0, 0}, 1, 0.5, 2}, {{4, 0, 0}, 2, 1, 4}}};
const Source triangle{{{{0, 0, 0}, 1, 1, 2}, {{4, 0, 0}, 1, 1, 2}, {{0, 4, 0}, 1, 1, 2}}};

TEST(NearestOnSource, is_found_on_a_line_and_at_its_ends) {
  EXPECT_DOUBLE_EQ(nearest_on_source(line, {1, 3, 4}).distance, 5);
  EXPECT_DOUBLE_EQ(nearest_on_source(line, {1, 3, 4}).weight[1], 0.25);
  EXPECT_DOUBLE_EQ(nearest_on_source(line, {-3, 4, 0}).distance, 5);
  EXPECT_DOUBLE_EQ(nearest_on_source(line, {7, 4, 0}).weight[1], 1);
}

TEST(NearestOnSource, is_found_on_the_face_edges_and_corners_of_a_triangle) {
  EXPECT_DOUBLE_EQ(nearest_on_source(triangle, {1, 1, -2}).distance, 2);
  EXPECT_DOUBLE_EQ(nearest_on_source(triangle, {1, 1, -2}).weight[0], 0.5);
  EXPECT_DOUBLE_EQ(nearest_on_source(triangle, {2, -3, 4}).distance, 5);
  EXPECT_DOUBLE_EQ(nearest_on_source(triangle, {4, 4, 0}).distance, std::sqrt(8));
  EXPECT_DOUBLE_EQ(nearest_on_source(triangle, {-3, -4, 0}).distance, 5);
}

TEST(NearestOnSource, works_on_flat_entities) {
  const Source point_like{{{{1, 1, 1}, 1, 1, 1}, {{1, 1, 1}, 1, 1, 1}}};
  EXPECT_DOUBLE_EQ(nearest_on_source(point_like, {1, 1, 3}).distance, 2);
  const Source line_like{{{{0, 0, 0}, 1, 1, 1}, {{2, 0, 0}, 1, 1, 1}, {{1, 0, 0}, 1, 1, 1}}};
  EXPECT_DOUBLE_EQ(nearest_on_source(line_like, {1.5, 2, 0}).distance, 2);
}

TEST(SourceDemand, interpolates_between_corners) {
  const SourceDemand demand = source_demand(line, 10);
  EXPECT_TRUE(demand.varies);
  EXPECT_DOUBLE_EQ(source_value(demand, {2, 0, 0}, 0, 100, 10).asked, 1.5);
  EXPECT_DOUBLE_EQ(source_value(demand, {2, 0.7, 0}, 0, 100, 10).asked, 1.5);
  EXPECT_LE(source_value(demand, {2, 2, 0}, 0, 100, 10).floor,
            source_value(demand, {2, 2, 0}, 0, 100, 10).asked);
}

TEST(SourceDemand, of_radii_that_vary_has_a_floor_below_all_it_asks_for) {
  const Source widening{{{{0, 0, 0}, 1, 0.5, 1}, {{4, 0, 0}, 1, 2, 4}}};
  const Source narrowing{{{{0, 0, 0}, 1, 2, 4}, {{4, 0, 0}, 1, 0.5, 1}}};
  for (const Source& source : {line, widening, narrowing}) {
    const SourceDemand demand = source_demand(source, 10);
    ASSERT_TRUE(demand.varies);
    for (double x = -6; x <= 10; x += 0.25) {
      for (double y = 0; y <= 6; y += 0.25) {
        const double radius = 0.5;
        const double floor = source_value(demand, {x, y, 0}, radius, 100, 10).floor;
        for (const Vec3& near : {Vec3{x, y, 0}, Vec3{x - radius, y, 0}, Vec3{x + radius, y, 0},
                                 Vec3{x, y - radius, 0}, Vec3{x, y, radius}}) {
          ASSERT_LE(floor, source_value(demand, near, 0, 100, 10).asked * (1 + 1e-12))
              << x << " " << y;
        }
      }
    }
  }
}

TEST(SourceDemand, limits_corners_by_the_growth_between_them) {
  EXPECT_DOUBLE_EQ(source_demand(line, 0.1).source.corners[1].spacing, 1.4);
}

Source solid(SourceShape shape, const Vec3& a, const Vec3& b, std::array<double, 2> radii = {}) {
  Source source;
  source.corners = {{a, 0.1, 0, 1}, {b, 0.1, 0, 1}};
  source.shape = shape;
  source.radii = radii;
  return source;
}

double off(const Source& source, const Vec3& point) {
  return nearest_on_source(source, point).distance;
}

TEST(BoxSource, is_as_far_as_its_nearest_point_and_near_everywhere_inside) {
  const Source box = solid(SourceShape::box, {0, 0, 0}, {2, 1, 1});
  EXPECT_EQ(off(box, {1, 0.5, 0.5}), 0);
  EXPECT_EQ(off(box, {2, 1, 1}), 0);
  EXPECT_EQ(off(box, {1, 0.5, 4}), 3);
  EXPECT_EQ(off(box, {-3, -4, 0.5}), 5);
}

TEST(CylinderSource, has_flat_ends_and_a_round_side) {
  const Source cylinder = solid(SourceShape::cylinder, {0, 0, 0}, {0, 0, 4}, {1, 1});
  EXPECT_EQ(off(cylinder, {0.5, 0.5, 2}), 0);
  EXPECT_EQ(off(cylinder, {0.9, 0, 4}), 0);
  EXPECT_DOUBLE_EQ(off(cylinder, {3, 0, 1}), 2);
  EXPECT_DOUBLE_EQ(off(cylinder, {0.5, 0, 6}), 2) << "beyond a flat end";
  EXPECT_DOUBLE_EQ(off(cylinder, {4, 0, -4}), 5) << "beyond the rim";
}

TEST(CylinderSource, of_two_radii_is_a_cone) {
  const Source cone = solid(SourceShape::cylinder, {0, 0, 0}, {3, 0, 0}, {3, 0});
  EXPECT_EQ(off(cone, {1, 1.9, 0}), 0);
  EXPECT_EQ(off(cone, {0, 3, 0}), 0);
  EXPECT_NEAR(off(cone, {3, 3, 0}), 3 / std::sqrt(2.0), 1e-14);
  EXPECT_DOUBLE_EQ(off(cone, {5, 0, 0}), 2) << "beyond the tip";
  EXPECT_DOUBLE_EQ(off(cone, {-1, 1, 1}), 1) << "behind the base";
  const Source turned = solid(SourceShape::cylinder, {3, 0, 0}, {0, 0, 0}, {0, 3});
  for (const Vec3& p : {Vec3{3, 3, 0}, Vec3{1, 5, 2}, Vec3{-2, -4, 1}}) {
    EXPECT_NEAR(off(cone, p), off(turned, p), 1e-14);
  }
}

TEST(SolidSources, are_never_farther_than_the_points_that_are_in_them) {
  const Source cone = solid(SourceShape::cylinder, {1, 2, 3}, {2, 5, 1}, {0.5, 2});
  const Vec3 axis = normalized(cone.corners[1].at - cone.corners[0].at);
  const Vec3 across = normalized(cross(axis, {1, 0, 0}));
  const Vec3 other = cross(axis, across);
  for (const Vec3& point : {Vec3{5, 5, 5}, Vec3{-3, 0, 1}, Vec3{2, 2, 9}, Vec3{1.5, 4, 2}}) {
    double least = HUGE_VAL;
    for (int i = 0; i <= 60; ++i) {
      const double share = i / 60.0;
      const Vec3 centre = cone.corners[0].at + share * (cone.corners[1].at - cone.corners[0].at);
      const double radius = 0.5 + share * 1.5;
      for (int k = 0; k < 90; ++k) {
        const double turn = 2 * std::acos(-1.0) * k / 90;
        for (const double part : {0.0, 0.5, 1.0}) {
          const Vec3 inside =
              centre + part * radius * (std::cos(turn) * across + std::sin(turn) * other);
          EXPECT_LT(off(cone, inside), 1e-12);
          least = std::min(least, distance(point, inside));
        }
      }
    }
    EXPECT_LE(off(cone, point), least + 1e-12);
    const bool is_inside = off(cone, point) == 0;
    EXPECT_TRUE(is_inside || off(cone, point) >= least - 0.05);
  }
}

}  // namespace
}  // namespace tetfarm
