#include "mesh/cosmetics/staged_improvement.h"

#include <gmock/gmock.h>

#include "mesh/cosmetics/quality.h"
#include "tests/mesh/cosmetics/trial_meshes.h"

namespace tetfarm::cosmetics {
namespace {

using testing::IsEmpty;

std::vector<BadTet> tets_of_angle(std::size_t count, double degrees) {
  return std::vector<BadTet>(count, {quality_of_angle(degrees), 0});
}

TEST(IsOfNeedles, when_more_than_one_tet_in_fifty_is_below_eight_degrees) {
  EXPECT_FALSE(is_of_needles(tets_of_angle(20, 7), 1000));
  EXPECT_TRUE(is_of_needles(tets_of_angle(21, 7), 1000));
}

TEST(IsOfNeedles, not_for_tets_that_are_only_not_good) {
  EXPECT_FALSE(is_of_needles(tets_of_angle(900, 9), 1000));
}

/// A drum of two rings of points, near each other along the rings and far across: Delaunay, but
/// without inner nodes, so that nearly all tets are bad.
TetMesh mesh_of_needles() {
  constexpr int sides = 150;
  std::vector<Vec3> points;
  for (int i = 0; i < 2 * sides; ++i) {
    const double angle = 2 * 3.14159265358979 * (i / 2) / sides;
    const double radius = 1 + 1e-3 * trial::random_unit(3, std::uint64_t(i));
    points.push_back({radius * std::cos(angle), radius * std::sin(angle), i % 2 == 0 ? 0.0 : 0.7});
  }
  return trial::delaunay_mesh(points, 2 * sides);
}

struct Improved {
  std::size_t tets_before = 0;
  std::size_t bad_before = 0;
  TetComplex complex;
  CosmeticReport report;
};

std::size_t bad_tets(const TetComplex& complex, double degrees) {
  std::size_t bad = 0;
  for (const Tet& tet : complex.nodes) {
    bad += tet[0] >= 0 && quality(complex, tet) < quality_of_angle(degrees) ? 1 : 0;
  }
  return bad;
}

Improved improved_needles(const TetMesh& mesh) {
  Improved improved;
  improved.complex = make_tet_complex(mesh);
  improved.tets_before = mesh.tets.size();
  improved.bad_before = bad_tets(improved.complex, 3);
  improved.report = improve_mesh(improved.complex, mesh.boundary_nodes);
  return improved;
}

TEST(StagedImprovement, tries_each_tet_of_a_mesh_of_needles_a_few_times_only) {
  const Improved improved = improved_needles(mesh_of_needles());
  ASSERT_GT(20 * improved.bad_before, improved.tets_before);
  EXPECT_THAT(validate(improved.complex), IsEmpty());
  EXPECT_LE(improved.report.attempts, 15 * std::ssize(improved.complex.nodes) + 7000)
      << improved.tets_before << " tets at first";
}

TEST(StagedImprovement, leaves_few_of_the_worst) {
  const Improved improved = improved_needles(mesh_of_needles());
  EXPECT_LE(10 * bad_tets(improved.complex, 3), improved.bad_before)
      << bad_tets(improved.complex, 3) << " of " << improved.bad_before;
  EXPECT_GE(improved.report.min_dihedral_after_deg, improved.report.min_dihedral_before_deg);
}

}  // namespace
}  // namespace tetfarm::cosmetics
