#include "mesh/cosmetics/joint_splitting.h"

#include <gmock/gmock.h>

#include "base/array_index.h"
#include "mesh/cosmetics/altitude_improvement.h"
#include "mesh/cosmetics/improve_mesh.h"
#include "mesh/cosmetics/quality.h"
#include "tests/mesh/cosmetics/trial_meshes.h"

namespace tetfarm::cosmetics {
namespace {

using testing::IsEmpty;

/// The tets by their nodes in rising order: what a mesh is, whatever the places of its tets.
std::vector<Tet> tets_of(const TetComplex& complex) {
  std::vector<Tet> tets;
  for (Tet tet : complex.nodes) {
    if (tet[0] < 0) continue;
    std::sort(tet.begin(), tet.end());
    tets.push_back(tet);
  }
  std::sort(tets.begin(), tets.end());
  return tets;
}

double volume_of(const TetComplex& complex) {
  double volume = 0;
  for (const auto& [a, b, c, d] : tets_of(complex)) {
    const auto point = [&](std::int32_t v) { return complex.points[at(v)]; };
    volume += std::fabs(tet_volume(point(a), point(b), point(c), point(d)));
  }
  return volume;
}

/// Random points in a ball, after all other cosmetics.
struct SettledBall {
  TetMesh mesh;
  TetComplex complex;
};
SettledBall settled_ball(std::uint64_t seed) {
  SettledBall ball;
  ball.mesh = trial::random_ball(1, 40, seed);
  ball.complex = make_tet_complex(ball.mesh);
  CosmeticOptions options;
  options.most_joint_failures = 4;
  improve_mesh(ball.complex, ball.mesh.boundary_nodes, options);
  return ball;
}

/// The squared height of the lowest tet.
double lowest2_of(const WorkMesh& work) {
  double lowest2 = HUGE_VAL;
  for (const auto& tet : tets_of(work.complex)) {
    const auto height2 = [&](std::int32_t i, std::int32_t j) {
      return smallest_height2(work.point(i), work.point(j), work.point(tet[2]), work.point(tet[3]));
    };
    lowest2 = std::min(lowest2, std::max(height2(tet[0], tet[1]), height2(tet[1], tet[0])));
  }
  return lowest2;
}

std::int32_t worst_tet(const WorkMesh& work) {
  std::int32_t worst = -1;
  for (std::int32_t t = 0; t < std::ssize(work.complex.nodes); ++t) {
    if (!work.complex.is_live(t)) continue;
    if (worst < 0 || work.quality_of(t) < work.quality_of(worst)) worst = t;
  }
  return worst;
}

TEST(JointSplitting, helps_the_worst_that_nothing_else_did_or_leaves_the_mesh_as_it_was) {
  int helped = 0;
  constexpr int meshes = 24;
  for (std::uint64_t seed = 1; seed <= meshes; ++seed) {
    SettledBall ball = settled_ball(seed);
    WorkMesh work(ball.complex, ball.mesh.boundary_nodes);
    const std::int32_t t = worst_tet(work);
    const double before = work.quality_of(t);
    const double lowest2 = lowest2_of(work);
    const double volume = volume_of(ball.complex);
    const std::vector<Tet> tets = tets_of(ball.complex);
    const std::vector<Vec3> points = ball.complex.points;
    const auto changed = split_together(work, t, 0.4, 0);
    EXPECT_THAT(validate(ball.complex), IsEmpty());
    EXPECT_NEAR(volume_of(ball.complex), volume, 1e-12);
    for (std::int32_t v = 0; v < ball.mesh.boundary_nodes; ++v) {
      EXPECT_EQ(ball.complex.points[at(v)], points[at(v)]);
    }
    if (changed.empty()) {
      EXPECT_EQ(tets_of(ball.complex), tets);
      EXPECT_TRUE(std::equal(points.begin(), points.end(), ball.complex.points.begin()));
      continue;
    }
    ++helped;
    for (const std::int32_t now : changed) EXPECT_TRUE(is_worth(before, work.quality_of(now)));
    EXPECT_GE(lowest2_of(work), lowest2);
    EXPECT_GE(work.quality_of(worst_tet(work)), before);
  }
  EXPECT_GE(helped, meshes / 4);
  EXPECT_LT(helped, meshes);
}

TEST(JointSplitting, keeps_the_distance_that_is_asked_for) {
  SettledBall ball = settled_ball(1);
  WorkMesh work(ball.complex, ball.mesh.boundary_nodes);
  const std::size_t points = ball.complex.points.size();
  EXPECT_THAT(split_together(work, worst_tet(work), 0.4, 2), IsEmpty());
  EXPECT_EQ(ball.complex.points.size(), points);
}

TEST(JointSplitting, raises_the_smallest_angle_of_a_mesh_where_it_is_below_the_limit) {
  int widened = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    const TetMesh mesh = trial::random_ball(1, 40, seed);
    const auto angle_with = [&mesh](double split_below) {
      TetComplex complex = make_tet_complex(mesh);
      CosmeticOptions options;
      options.wanted_dihedral_deg = 60;
      options.relaxed_dihedral_deg = 0;
      options.most_joint_failures = 4;
      options.jointly_split_dihedral_deg = split_below;
      const CosmeticReport report = improve_mesh(complex, mesh.boundary_nodes, options);
      EXPECT_THAT(validate(complex), IsEmpty());
      return report.min_dihedral_after_deg;
    };
    const double without = angle_with(0);
    const double with = angle_with(60);
    EXPECT_GE(with, without) << seed;
    EXPECT_EQ(angle_with(0.5 * without), without) << seed;
    if (with > without + 0.2) ++widened;
  }
  EXPECT_GE(widened, 3);
}

}  // namespace
}  // namespace tetfarm::cosmetics
