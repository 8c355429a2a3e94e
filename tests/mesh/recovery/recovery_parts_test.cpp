#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "mesh/geometry/bowyer_watson.h"
#include "mesh/geometry/predicates.h"
#include "mesh/recovery/boundary_recovery.h"
#include "mesh/recovery/inside_tets.h"
#include "mesh/recovery/kernel_point.h"
#include "mesh/recovery/recovery_guard.h"
#include "mesh/recovery/recovery_surface.h"
#include "mesh/recovery/ring_triangulation.h"
#include "mesh/recovery/surface_splitting.h"
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

TEST(RingTriangulation, of_an_octahedron_axis_counts_what_crosses_a_missing_edge) {
  const std::vector<Vec3> points = {{0, 0, -1}, {0, 0, 1},  {1, 0, 0},
                                    {0, 1, 0},  {-1, 0, 0}, {0, -1, 0}};
  TetComplex complex = bowyer_watson(points).complex;
  std::vector<std::uint8_t> constrained;
  LocalRemeshing mesh(complex, constrained);
  // Whichever diagonal is there has a ring of four.
  for (const auto& [a, b] : {std::array{0, 1}, std::array{2, 4}, std::array{3, 5}}) {
    const auto ring = mesh.ring(a, b);
    if (!ring) continue;
    ASSERT_EQ(ring->apexes.size(), 4U);
    const auto free = RecoveryGuard::of_nothing(mesh);
    const auto triangles = ring_triangulation(mesh, *ring, a, b, -1, free);
    ASSERT_TRUE(triangles.has_value());
    EXPECT_EQ(triangles->triangles.size(), 2U);
    EXPECT_EQ(triangles->crossings, 0);
    // Both other diagonals cross this one.
    const auto own = RecoveryGuard::of_edge(mesh, a, b);
    EXPECT_GT(ring_triangulation(mesh, *ring, a, b, -1, own)->crossings, 0);
  }
}

TEST(InsideTets, are_those_between_nested_spheres) {
  const Subdomain domain = root_subdomain(shapes::nested_spheres(2));
  DelaunayTets tets = bowyer_watson(domain.vertices);
  std::vector<std::uint8_t> constrained(tets.complex.nodes.size(), 0);
  const RecoveredBoundary recovered = recover_boundary(tets.complex, constrained, domain.triangles);
  ASSERT_TRUE(recovered.lost.empty());
  const RecoverySurface surface(domain.triangles,
                                static_cast<std::int32_t>(tets.complex.points.size()));
  const LocalRemeshing mesh(tets.complex, constrained);
  const auto inside = inside_tets(mesh, surface);
  const auto nodes = static_cast<std::int32_t>(domain.vertices.size());
  const InsideComplex kept = keep_inside(tets.complex, constrained, inside, nodes, 4);
  EXPECT_TRUE(validate(kept.complex).empty());
  expect_mesh_of(to_tet_mesh(kept.complex, nodes), domain);
}

TEST(InsideTets, are_none_when_the_boundary_leaks) {
  const Subdomain domain = root_subdomain(shapes::sphere({0, 0, 0}, 1, 1));
  DelaunayTets tets = bowyer_watson(domain.vertices);
  std::vector<std::uint8_t> constrained(tets.complex.nodes.size(), 0);
  recover_boundary(tets.complex, constrained, domain.triangles);
  const auto& [a, b, c] = domain.triangles.front();
  LocalRemeshing mesh(tets.complex, constrained);
  const RecoverySurface surface(domain.triangles,
                                static_cast<std::int32_t>(tets.complex.points.size()));
  EXPECT_FALSE(inside_tets(mesh, surface).empty());
  mesh.constrain(mesh.find_face(a, b, c), false);
  EXPECT_TRUE(inside_tets(mesh, surface).empty());
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
