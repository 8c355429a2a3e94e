#include "mesh/cosmetics/height_raising.h"

#include <gmock/gmock.h>

#include "mesh/cosmetics/quality.h"
#include "tests/mesh/cosmetics/trial_meshes.h"

namespace tetfarm::cosmetics {
namespace {

using testing::IsEmpty;

double height2_of(const WorkMesh& work, const Tet& tet) {
  return smallest_height2(work.point(tet[0]), work.point(tet[1]), work.point(tet[2]),
                          work.point(tet[3]));
}

double lowest2(const WorkMesh& work) {
  double lowest = HUGE_VAL;
  for (const Tet& tet : work.complex.nodes) lowest = std::min(lowest, height2_of(work, tet));
  return lowest;
}

double worst_goodness(const WorkMesh& work) {
  double worst = 1;
  for (const Tet& tet : work.complex.nodes) worst = std::min(worst, goodness(work.complex, tet));
  return worst;
}

HeightOptions wanting(double length, double floor = 0) {
  HeightOptions options;
  options.wanted_length = length;
  options.floor = floor;
  return options;
}

TEST(HeightRaising, the_smallest_height_of_a_tet_is_that_over_its_largest_face) {
  // Legs 1, 1 and 2: the largest face is the slanted one, of area 3/2; the volume is 1/3.
  const Vec3 o{0, 0, 0};
  const Vec3 x{1, 0, 0};
  const Vec3 y{0, 1, 0};
  EXPECT_NEAR(smallest_height2(o, x, y, {0, 0, 2}), 4.0 / 9, 1e-12);
  EXPECT_EQ(smallest_height2(o, x, y, {0.5, 0.5, 0}), 0);
  EXPECT_EQ(smallest_height2(x, o, y, {0, 0, 2}), 0);
}

TEST(HeightRaising, lifts_the_lowest_tets_and_leaves_angles_above_the_floor) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const TetMesh mesh = trial::kuhn_box(5, 0.6, seed);
    TetComplex complex = make_tet_complex(mesh);
    WorkMesh work(complex, mesh.boundary_nodes);
    const double lowest = lowest2(work);
    const double worst = worst_goodness(work);
    const double floor = goodness_of_angle(20);
    EXPECT_GT(raise_heights(work, wanting(0.45, floor)), 5);
    EXPECT_GT(lowest2(work), 1.2 * lowest) << seed;
    EXPECT_GE(worst_goodness(work), std::min(worst, floor)) << seed;
    EXPECT_THAT(validate(complex), IsEmpty());
    for (std::int32_t v = 0; v < mesh.boundary_nodes; ++v) {
      EXPECT_EQ(work.point(v), mesh.nodes[static_cast<std::size_t>(v)]);
    }
  }
}

TEST(HeightRaising, no_tet_gets_worse_than_the_floor_that_was_better_before) {
  const TetMesh mesh = trial::kuhn_box(4, 0.5, 7);
  TetComplex complex = make_tet_complex(mesh);
  WorkMesh work(complex, mesh.boundary_nodes);
  // The floor is above what is there: then no move may lower the smallest goodness of a ball.
  std::vector<double> before;
  for (const Tet& tet : complex.nodes) before.push_back(goodness(complex, tet));
  const double worst = *std::min_element(before.begin(), before.end());
  EXPECT_GT(raise_heights(work, wanting(0.6, 1)), 0);
  EXPECT_GE(worst_goodness(work), worst);
}

TEST(HeightRaising, nothing_moves_where_all_are_high_enough) {
  const TetMesh mesh = trial::kuhn_box(4, 0.4, 2);
  TetComplex complex = make_tet_complex(mesh);
  WorkMesh work(complex, mesh.boundary_nodes);
  const double wanted = 0.999 * std::sqrt(lowest2(work));
  EXPECT_EQ(raise_heights(work, wanting(wanted)), 0);
  EXPECT_GT(raise_heights(work, wanting(1.2 * wanted)), 0);
}

TEST(HeightRaising, a_few_stuck_tets_end_it_when_the_lowest_are_raised) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const TetMesh mesh = trial::kuhn_box(6, 0.6, seed);
    const auto raised = [&mesh](std::int64_t most_stuck) {
      TetComplex complex = make_tet_complex(mesh);
      WorkMesh work(complex, mesh.boundary_nodes);
      HeightOptions options = wanting(0.7, goodness_of_angle(20));
      options.most_stuck = most_stuck;
      const std::int64_t moves = raise_heights(work, options);
      return std::pair(moves, lowest2(work));
    };
    const double lowest_at_first = raised(0).second;
    const auto [few, lowest_of_few] = raised(4);
    const std::int64_t all = raised(1'000'000).first;
    EXPECT_EQ(raised(0).first, 0);
    EXPECT_GT(few, 5) << seed;
    EXPECT_LT(2 * few, all) << seed;
    EXPECT_GT(lowest_of_few, 1.2 * lowest_at_first) << seed;
  }
}

TEST(HeightRaising, a_low_tet_is_as_high_as_is_wanted_where_spacings_are_small) {
  const TetMesh mesh = trial::kuhn_box(6, 0.6, 3);
  TetComplex complex = make_tet_complex(mesh);
  WorkMesh work(complex, mesh.boundary_nodes);
  HeightOptions options;
  options.wanted_spacings = 0.45;
  options.spacing = [](const Vec3& p) { return p.x < 3 ? 0.001 : 1.0; };
  EXPECT_GT(raise_heights(work, options), 5);
  for (std::size_t v = 0; v < mesh.nodes.size(); ++v) {
    if (mesh.nodes[v].x < 1.5) {
      EXPECT_EQ(complex.points[v], mesh.nodes[v]);
    }
  }
}

}  // namespace
}  // namespace tetfarm::cosmetics
