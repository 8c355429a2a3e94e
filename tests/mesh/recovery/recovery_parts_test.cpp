#include <gtest/gtest.h>

#include <cmath>

#include "mesh/geometry/bowyer_watson.h"
#include "mesh/recovery/boundary_recovery.h"
#include "mesh/recovery/kernel_point.h"
#include "mesh/recovery/recovery_guard.h"
#include "mesh/recovery/recovery_surface.h"
#include "tests/mesh/volume/volume_checks.h"

namespace tetfarm {
namespace {

TEST(RecoverySurface, knows_its_edges_and_triangles_in_any_order_of_nodes) {
  const SurfaceMesh cube = shapes::unit_cube();
  const RecoverySurface surface(cube.triangles, 8);
  EXPECT_EQ(surface.edges().size(), 18U);
  for (std::size_t i = 0; i < cube.triangles.size(); ++i) {
    const auto& [a, b, c] = cube.triangles[i];
    EXPECT_TRUE(surface.has_edge(b, a));
    EXPECT_EQ(surface.find_triangle(c, a, b), static_cast<std::int32_t>(i));
  }
  EXPECT_FALSE(surface.has_edge(0, 100));
  EXPECT_EQ(surface.find_triangle(0, 1, 100), -1);
}

/// Points without tets, to ask guards about.
struct Points {
  explicit Points(std::vector<Vec3> places) : complex{std::move(places), {}, {}, {}, {}} {}
  TetComplex complex;
  std::vector<std::uint8_t> constrained;
  LocalRemeshing mesh{complex, constrained};
};

TEST(RecoveryGuard, of_an_edge_counts_what_crosses_it_and_nothing_that_shares_an_end) {
  const Points p({{0, 0, -1}, {0, 0, 1}, {1, 0, 0}, {-1, 1, 0}, {-1, -1, 0}, {-1, 0, 0}});
  const auto guard = RecoveryGuard::of_edge(p.mesh, 0, 1);
  EXPECT_EQ(guard.crossings(2, 3, 4), 1);
  EXPECT_EQ(guard.crossings(3, 4, 5), 0);
  EXPECT_EQ(guard.crossings(0, 2, 3), 0);
  EXPECT_EQ(guard.crossings(2, 5), 1);
  EXPECT_EQ(guard.crossings(3, 4), 0);
  EXPECT_EQ(guard.crossings(0, 5), 0);
  EXPECT_EQ(RecoveryGuard::of_nothing(p.mesh).crossings(2, 3, 4), 0);
  EXPECT_EQ(RecoveryGuard::of_nothing(p.mesh).crossings(2, 5), 0);
}

TEST(RecoveryGuard, of_a_face_counts_edges_through_it_or_across_its_sides) {
  const Points p({{0, 0, 0},
                  {1, 0, 0},
                  {0, 1, 0},
                  {0.2, 0.2, 1},
                  {0.2, 0.2, -1},
                  {2, 2, -1},
                  {0.3, -1, 0},
                  {0.3, 0.2, 0}});
  const auto guard = RecoveryGuard::of_face(p.mesh, {0, 1, 2});
  EXPECT_EQ(guard.crossings(3, 4), 1);
  EXPECT_EQ(guard.crossings(3, 5), 0);
  EXPECT_EQ(guard.crossings(6, 7), 1);
  EXPECT_EQ(guard.crossings(0, 1), 0);
}

TEST(SegmentsCross, only_between_their_ends_and_in_one_plane) {
  const auto cross = [](const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    const Points p({a, b, c, d});
    return segments_cross(p.mesh, 0, 1, 2, 3);
  };
  EXPECT_TRUE(cross({0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}));
  EXPECT_FALSE(cross({0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 1e-9}));
  EXPECT_FALSE(cross({0, 0, 0}, {1, 1, 0}, {1, 1, 0}, {0, 1, 0}));
  EXPECT_FALSE(cross({0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}));
  EXPECT_FALSE(cross({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}));
}

TEST(SegmentsCross, no_triangle_that_they_only_touch) {
  const auto crosses = [](const Vec3& p, const Vec3& q) {
    const Points points({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, p, q});
    return segment_crosses_triangle(points.mesh, 3, 4, {0, 1, 2});
  };
  EXPECT_TRUE(crosses({0.2, 0.2, -1}, {0.2, 0.2, 1}));
  EXPECT_TRUE(crosses({0.5, 0.5, -1}, {0.5, 0.5, 1}));
  EXPECT_FALSE(crosses({1, 0, -1}, {1, 0, 1}));
  EXPECT_FALSE(crosses({0.2, 0.2, 0}, {0.2, 0.2, 1}));
  EXPECT_FALSE(crosses({0.8, 0.8, -1}, {0.8, 0.8, 1}));
}

TEST(KernelPoint, of_a_cube_is_well_inside_and_of_facing_away_planes_there_is_none) {
  const SurfaceMesh cube = shapes::unit_cube();
  std::vector<VisibleFace> faces;
  for (const auto& [a, b, c] : cube.triangles) {
    const auto p = [&cube](std::int32_t v) {
      return fine(cube.vertices[static_cast<std::size_t>(v)]);
    };
    faces.push_back({p(a), p(c), p(b)});
  }
  const auto point = kernel_point(faces, fine({0, 0, 0}));
  ASSERT_TRUE(point.has_value());
  for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(point->high[axis], 0.5, 0.2);
  const std::vector<VisibleFace> opposed = {{fine({0, 0, 1}), fine({1, 0, 1}), fine({0, 1, 1})},
                                            {fine({0, 0, 0}), fine({0, 1, 0}), fine({1, 0, 0})}};
  EXPECT_FALSE(kernel_point(opposed, fine({0, 0, 0})).has_value());
}

TEST(KernelPoint, is_found_in_a_wedge_far_thinner_than_the_last_digit_of_doubles) {
  const double height = std::ldexp(1.0, -80);
  const auto lifted = [height](double x, double y) { return FinePoint{{x, y, 1}, {0, 0, height}}; };
  const std::vector<VisibleFace> faces = {{fine({0, 0, 1}), fine({1, 0, 1}), fine({0, 1, 1})},
                                          {lifted(0, 0), lifted(0, 1), lifted(1, 0)}};
  const auto point = kernel_point(faces, fine({0.3, 0.3, 1}));
  ASSERT_TRUE(point.has_value());
  EXPECT_TRUE(sees_all(faces, *point));
  EXPECT_FALSE(sees_all(faces, fine({0.3, 0.3, 1})));
}

TEST(MissingEdges, are_those_that_a_twisted_surface_has_and_its_delaunay_tets_have_not) {
  const SurfaceMesh twisted = shapes::schoenhardt();
  const TetComplex complex = bowyer_watson(twisted.vertices).complex;
  const RecoverySurface surface(twisted.triangles, 6);
  EXPECT_GT(missing_edges(complex, surface).size(), 0U);
  const SurfaceMesh cube = shapes::sphere({0, 0, 0}, 1, 1);
  EXPECT_TRUE(missing_edges(
                  bowyer_watson(cube.vertices).complex,
                  RecoverySurface(cube.triangles, static_cast<std::int32_t>(cube.vertices.size())))
                  .empty());
}

}  // namespace
}  // namespace tetfarm
