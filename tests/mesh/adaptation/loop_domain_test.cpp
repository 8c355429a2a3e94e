#include "mesh/adaptation/loop_domain.h"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "base/error.h"

namespace tetfarm {
namespace {

std::vector<Vec2> circle_points(double radius, int count, bool is_clockwise) {
  std::vector<Vec2> points;
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * i / count * (is_clockwise ? -1 : 1);
    points.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  return points;
}

double area_of(const PlaneMesh& mesh) {
  double doubled = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vec2& p = mesh.points[static_cast<std::size_t>(a)];
    const Vec2& q = mesh.points[static_cast<std::size_t>(b)];
    const Vec2& r = mesh.points[static_cast<std::size_t>(c)];
    doubled += (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
  }
  return doubled / 2;
}

double polygon_area(double radius, int count) {
  return radius * radius * count / 2.0 * std::sin(2 * std::numbers::pi / count);
}

TEST(LoopDomain, is_what_an_odd_number_of_loops_encloses_whatever_way_they_run) {
  for (const int turned : {0, 1, 2, 3, 4, 5, 6, 7}) {
    const PlaneMesh mesh = domain_of_loops({{circle_points(3, 12, (turned & 1) != 0), 1, "a"},
                                            {circle_points(2, 12, (turned & 2) != 0), 2, "b"},
                                            {circle_points(1, 12, (turned & 4) != 0), 3, "c"}});
    EXPECT_NEAR(area_of(mesh), polygon_area(3, 12) - polygon_area(2, 12) + polygon_area(1, 12),
                1e-12);
    EXPECT_EQ(mesh.points.size(), 36U);
    EXPECT_EQ(mesh.edges.size(), 36U);
    EXPECT_THAT(mesh.patches, ::testing::Contains(3).Times(12));
  }
}

TEST(LoopDomain, refuses_loops_that_cross_with_the_place) {
  try {
    domain_of_loops({{{{0, 0}, {1, 1}, {1, 0}, {0, 1}}, 1, "cross.xy:1"}});
    FAIL();
  } catch (const InvalidInput& error) {
    EXPECT_THAT(error.what(), ::testing::HasSubstr("cross.xy:1: "));
    EXPECT_THAT(error.what(), ::testing::HasSubstr("(0.5, 0.5)"));
  }
}

TEST(LoopDomain, sizes_grow_in_proportion_to_the_way_from_short_edges_to_long_ones) {
  const PlaneMesh domain = domain_of_loops(
      {{circle_points(20, 40, false), 1, "far"}, {circle_points(0.5, 300, false), 2, "near"}});
  const MeshWithMetrics sized = sized_by_boundary(domain);
  const double near = 2 * 0.5 * std::sin(std::numbers::pi / 300);
  const double far = 2 * 20 * std::sin(std::numbers::pi / 40);
  EXPECT_GT(sized.mesh.points.size(), domain.points.size());
  for (std::size_t v = 0; v < sized.mesh.points.size(); ++v) {
    const Vec2& p = sized.mesh.points[v];
    const double share = (std::hypot(p.x, p.y) - 0.5) / 19.5;
    const double size = 1 / std::sqrt(sized.metrics[v].xx);
    EXPECT_NEAR(size / (near + share * (far - near)), 1, 0.1) << p.x << " " << p.y;
  }
}

}  // namespace
}  // namespace tetfarm
