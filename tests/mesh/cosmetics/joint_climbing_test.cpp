#include "mesh/cosmetics/joint_climbing.h"

#include <gmock/gmock.h>

#include "base/array_index.h"
#include "mesh/cosmetics/altitude_improvement.h"
#include "mesh/cosmetics/improve_mesh.h"
#include "mesh/cosmetics/quality.h"
#include "tests/mesh/cosmetics/trial_meshes.h"

namespace tetfarm::cosmetics {
namespace {

using testing::IsEmpty;

double lowest2(const WorkMesh& work) {
  double lowest = HUGE_VAL;
  for (const Tet& tet : work.complex.nodes) {
    if (tet[0] < 0) continue;
    lowest = std::min(lowest, smallest_height2(work.point(tet[0]), work.point(tet[1]),
                                               work.point(tet[2]), work.point(tet[3])));
  }
  return lowest;
}

double worst_quality(const WorkMesh& work) {
  double worst = 1;
  for (std::int32_t t = 0; t < std::ssize(work.complex.nodes); ++t) {
    if (work.complex.is_live(t)) worst = std::min(worst, work.quality_of(t));
  }
  return worst;
}

TEST(JointClimbing, the_smallest_pieces_of_a_tet_are_its_quality_and_its_smallest_height) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    std::array<Vec3, 4> p;
    for (std::size_t i = 0; i < 4; ++i) p[i] = trial::random_vector(seed, i);
    if (tet_volume(p[0], p[1], p[2], p[3]) < 0) std::swap(p[0], p[1]);
    const TetPieces pieces = pieces_of(p[0], p[1], p[2], p[3]);
    EXPECT_NEAR(std::ranges::min(pieces.sines2), quality(p[0], p[1], p[2], p[3]), 1e-12);
    EXPECT_NEAR(std::ranges::min(pieces.heights2), smallest_height2(p[0], p[1], p[2], p[3]), 1e-12);
    std::swap(p[2], p[3]);
    EXPECT_LT(std::ranges::max(pieces_of(p[0], p[1], p[2], p[3]).sines2), 0);
  }
}

TEST(JointClimbing, a_patch_has_inner_nodes_only_and_all_tets_that_hold_one) {
  const TetMesh mesh = trial::kuhn_box(5, 0.5, 3);
  TetComplex complex = make_tet_complex(mesh);
  WorkMesh work(complex, mesh.boundary_nodes);
  for (std::int32_t t = 0; t < std::ssize(mesh.tets); t += 37) {
    const NodePatch patch = patch_round(work, t);
    for (const std::int32_t v : patch.nodes) EXPECT_GE(v, mesh.boundary_nodes);
    for (std::int32_t other = 0; other < std::ssize(mesh.tets); ++other) {
      const Tet& tet = mesh.tets[at(other)];
      const bool holds_one = std::ranges::find_first_of(tet, patch.nodes) != tet.end();
      EXPECT_EQ(std::ranges::count(patch.tets, other), holds_one ? 1 : 0);
    }
    ASSERT_EQ(patch.corners.size(), patch.tets.size());
    for (std::size_t i = 0; i < patch.tets.size(); ++i) {
      for (std::size_t k = 0; k < 4; ++k) {
        EXPECT_EQ(patch.points[at(patch.corners[i][k])], work.point(work.tet(patch.tets[i])[k]));
      }
    }
  }
}

TEST(JointClimbing, a_direction_goes_up_for_all_slopes_and_is_none_where_two_are_opposed) {
  const auto along = [](std::int32_t node, const Vec3& slope) {
    return TetSlope{{node, -1, -1, -1}, {slope, {}, {}, {}}};
  };
  const std::vector<TetSlope> agreeing = {along(0, {1, 0, 0}), along(0, {-0.5, 1, 0}),
                                          along(1, {0, 0, 2})};
  const std::vector<Vec3> up = direction_up(agreeing, 2);
  ASSERT_EQ(up.size(), 2U);
  EXPECT_GT(dot(up[0], Vec3{1, 0, 0}), 0.01);
  EXPECT_GT(dot(up[0], Vec3{-0.5, 1, 0}), 0.01);
  EXPECT_GT(up[1].z, 0.01);
  EXPECT_NEAR(std::max(norm(up[0]), norm(up[1])), 1, 1e-12);
  EXPECT_THAT(direction_up({along(0, {1, 0, 0}), along(0, {-1, 0, 0})}, 1), IsEmpty());
  EXPECT_THAT(direction_up({}, 3), IsEmpty());
}

TEST(JointClimbing, neighbours_together_raise_heights_that_no_node_can_alone) {
  int raised = 0;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const TetMesh mesh = trial::kuhn_box(5, 0.6, seed);
    TetComplex complex = make_tet_complex(mesh);
    WorkMesh work(complex, mesh.boundary_nodes);
    HeightOptions options;
    options.wanted_length = 0.7;
    options.floor = quality_of_angle(20);
    improve_altitudes(work, options);
    EXPECT_EQ(improve_altitudes(work, options), 0);
    const double alone = lowest2(work);
    const double worst = worst_quality(work);
    options.most_joint_failures = 8;
    EXPECT_GT(improve_altitudes(work, options), 0) << seed;
    EXPECT_GE(lowest2(work), alone) << seed;
    if (lowest2(work) > 1.03 * alone) ++raised;
    EXPECT_GE(worst_quality(work), std::min(worst, options.floor)) << seed;
    EXPECT_THAT(validate(complex), IsEmpty());
    for (std::int32_t v = 0; v < mesh.boundary_nodes; ++v) {
      EXPECT_EQ(work.point(v), mesh.nodes[at(v)]);
    }
  }
  EXPECT_GE(raised, 3);
}

TEST(JointClimbing, neighbours_together_widen_angles_that_nothing_else_can) {
  int widened = 0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const TetMesh mesh = trial::kuhn_box(5, 0.6, seed);
    const auto angle_with = [&mesh](std::int64_t most_failures) {
      TetComplex complex = make_tet_complex(mesh);
      CosmeticOptions options;
      options.wanted_dihedral_deg = 60;
      options.relaxed_dihedral_deg = 0;
      options.most_joint_failures = most_failures;
      const CosmeticReport report = improve_mesh(complex, mesh.boundary_nodes, options);
      EXPECT_THAT(validate(complex), IsEmpty());
      EXPECT_EQ(report.joint_moves > 0, most_failures > 0);
      return report.min_dihedral_after_deg;
    };
    const double alone = angle_with(0);
    const double together = angle_with(8);
    EXPECT_GE(together, alone) << seed;
    if (together > alone + 0.5) ++widened;
  }
  EXPECT_GE(widened, 3);
}

}  // namespace
}  // namespace tetfarm::cosmetics
