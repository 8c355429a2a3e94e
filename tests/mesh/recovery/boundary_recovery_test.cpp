#include "mesh/recovery/boundary_recovery.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>

#include "mesh/geometry/bowyer_watson.h"
#include "mesh/recovery/local_remeshing.h"
#include "mesh/recovery/recovery_surface.h"
#include "tests/mesh/volume/volume_checks.h"

namespace tetfarm {
namespace {

struct Recovery {
  explicit Recovery(const SurfaceMesh& surface, std::uint64_t seed = 0)
      : triangles(surface.triangles), complex(bowyer_watson(surface.vertices).complex) {
    constrained.assign(complex.nodes.size(), 0);
    outcome = recover_boundary(complex, constrained, triangles, seed);
  }
  /// Every triangle is a face, constrained on both sides, and no other face is.
  void expect_all_recovered() {
    EXPECT_TRUE(outcome.lost.empty());
    LocalRemeshing mesh(complex, constrained);
    for (const auto& [a, b, c] : triangles) {
      const FaceHandle face = mesh.find_face(a, b, c);
      ASSERT_NE(face, no_face);
      EXPECT_TRUE(mesh.is_constrained(face));
    }
    int sides = 0;
    for (std::int32_t t = 0; at(t) < complex.nodes.size(); ++t) {
      if (complex.is_live(t)) sides += std::popcount(constrained[at(t)]);
    }
    EXPECT_EQ(sides, 2 * static_cast<int>(triangles.size()));
  }

  std::vector<Triangle> triangles;
  TetComplex complex;
  std::vector<std::uint8_t> constrained;
  RecoveredBoundary outcome;
};

TEST(BoundaryRecovery, has_nothing_to_do_where_the_delaunay_tets_have_all_triangles) {
  Recovery sphere(shapes::sphere({0, 0, 0}, 1, 2));
  sphere.expect_all_recovered();
  EXPECT_EQ(sphere.outcome.missing_edges, 0);
  EXPECT_EQ(sphere.outcome.missing_faces, 0);
  EXPECT_EQ(sphere.outcome.splits, 0);
}

TEST(BoundaryRecovery, gets_back_by_flips_what_is_missing) {
  Recovery star(shapes::random_star(2, 0.25, 1.5, 5));
  star.expect_all_recovered();
  EXPECT_GT(star.outcome.missing_edges, 0);
}

TEST(BoundaryRecovery, leaves_a_point_inside_where_nothing_else_helps) {
  for (const std::uint64_t seed : {0U, 1U, 2U}) {
    Recovery twisted(shapes::schoenhardt(), seed);
    twisted.expect_all_recovered();
    EXPECT_GE(twisted.outcome.splits, 1);
    EXPECT_EQ(twisted.outcome.steiner_points, 1);
  }
}

TEST(BoundaryRecovery, names_the_triangles_that_cut_each_other) {
  SurfaceMesh both = shapes::sphere({0, 0, 0}, 1, 1);
  const SurfaceMesh other = shapes::sphere({1.1, 0.03, 0.02}, 1, 1);
  const auto offset = static_cast<std::int32_t>(both.vertices.size());
  both.vertices.insert(both.vertices.end(), other.vertices.begin(), other.vertices.end());
  for (const auto& [a, b, c] : other.triangles) {
    both.triangles.push_back({a + offset, b + offset, c + offset});
  }
  const Recovery crossing(both);
  ASSERT_FALSE(crossing.outcome.lost.empty());
  for (const std::int32_t t : crossing.outcome.lost) {
    EXPECT_GE(t, 0);
    EXPECT_LT(at(t), both.triangles.size());
  }
}

TEST(MissingEdges, are_the_edges_of_the_surface_that_no_tet_has) {
  const SurfaceMesh star = shapes::random_star(2, 0.25, 1.5, 5);
  const TetComplex complex = bowyer_watson(star.vertices).complex;
  std::vector<std::uint8_t> constrained(complex.nodes.size(), 0);
  TetComplex copy = complex;
  const LocalRemeshing mesh(copy, constrained);
  const RecoverySurface surface(star.triangles, static_cast<std::int32_t>(star.vertices.size()));
  const auto missing = missing_edges(complex, surface);
  EXPECT_TRUE(std::ranges::is_sorted(missing));
  for (const auto& [a, b, c] : star.triangles) {
    for (const auto& [u, v] : {std::array{a, b}, std::array{b, c}, std::array{c, a}}) {
      const std::array<std::int32_t, 2> edge = {std::min(u, v), std::max(u, v)};
      EXPECT_EQ(std::ranges::binary_search(missing, edge), mesh.find_edge(u, v) < 0);
    }
  }
  EXPECT_FALSE(missing.empty());
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
