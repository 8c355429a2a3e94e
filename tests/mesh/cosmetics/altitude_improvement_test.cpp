#include "mesh/cosmetics/altitude_improvement.h"

#include <gmock/gmock.h>

#include "mesh/cosmetics/quality.h"
#include "mesh/cosmetics/smoothing.h"
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
  for (const Tet& tet : work.complex.nodes) {
    if (tet[0] >= 0) lowest = std::min(lowest, height2_of(work, tet));
  }
  return lowest;
}

double worst_quality(const WorkMesh& work) {
  double worst = 1;
  for (const Tet& tet : work.complex.nodes) {
    if (tet[0] >= 0) worst = std::min(worst, quality(work.complex, tet));
  }
  return worst;
}

HeightOptions wanting(double length, double floor = 0) {
  HeightOptions options;
  options.wanted_length = length;
  options.floor = floor;
  return options;
}

TEST(AltitudeImprovement, the_smallest_height_of_a_tet_is_that_over_its_largest_face) {
  // Legs 1, 1 and 2: the largest face is the slanted one, of area 3/2; the volume is 1/3.
  const Vec3 o{0, 0, 0};
  const Vec3 x{1, 0, 0};
  const Vec3 y{0, 1, 0};
  EXPECT_NEAR(smallest_height2(o, x, y, {0, 0, 2}), 4.0 / 9, 1e-12);
  EXPECT_EQ(smallest_height2(o, x, y, {0.5, 0.5, 0}), 0);
  EXPECT_EQ(smallest_height2(x, o, y, {0, 0, 2}), 0);
}

TEST(AltitudeImprovement, lifts_the_lowest_tets_and_leaves_angles_above_the_floor) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const TetMesh mesh = trial::kuhn_box(5, 0.6, seed);
    TetComplex complex = make_tet_complex(mesh);
    WorkMesh work(complex, mesh.boundary_nodes);
    const double lowest = lowest2(work);
    const double worst = worst_quality(work);
    const double floor = quality_of_angle(20);
    EXPECT_GT(improve_altitudes(work, wanting(0.45, floor)), 5);
    EXPECT_GT(lowest2(work), 1.2 * lowest) << seed;
    EXPECT_GE(worst_quality(work), std::min(worst, floor)) << seed;
    EXPECT_THAT(validate(complex), IsEmpty());
    for (std::int32_t v = 0; v < mesh.boundary_nodes; ++v) {
      EXPECT_EQ(work.point(v), mesh.nodes[static_cast<std::size_t>(v)]);
    }
  }
}

TEST(AltitudeImprovement, no_tet_gets_worse_than_the_floor_that_was_better_before) {
  const TetMesh mesh = trial::kuhn_box(4, 0.5, 7);
  TetComplex complex = make_tet_complex(mesh);
  WorkMesh work(complex, mesh.boundary_nodes);
  // The floor is above what is there: then no move may lower the smallest quality of a ball.
  std::vector<double> before;
  for (const Tet& tet : complex.nodes) before.push_back(quality(complex, tet));
  const double worst = *std::min_element(before.begin(), before.end());
  EXPECT_GT(improve_altitudes(work, wanting(0.6, 1)), 0);
  EXPECT_GE(worst_quality(work), worst);
}

TEST(AltitudeImprovement, nothing_moves_where_all_are_high_enough) {
  const TetMesh mesh = trial::kuhn_box(4, 0.4, 2);
  TetComplex complex = make_tet_complex(mesh);
  WorkMesh work(complex, mesh.boundary_nodes);
  const double wanted = 0.999 * std::sqrt(lowest2(work));
  EXPECT_EQ(improve_altitudes(work, wanting(wanted)), 0);
  EXPECT_GT(improve_altitudes(work, wanting(1.2 * wanted)), 0);
}

TEST(AltitudeImprovement, a_few_stuck_tets_end_it_when_the_lowest_are_raised) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const TetMesh mesh = trial::kuhn_box(6, 0.6, seed);
    const auto raised = [&mesh](std::int64_t most_stuck) {
      TetComplex complex = make_tet_complex(mesh);
      WorkMesh work(complex, mesh.boundary_nodes);
      HeightOptions options = wanting(0.7, quality_of_angle(20));
      options.most_stuck = most_stuck;
      const std::int64_t moves = improve_altitudes(work, options);
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

/// Tets round one inner node, 8: two of them over a needle triangle and its neighbour at a sharp
/// edge, where what is good for the angles of the one is bad for the height of the other.
TetMesh tets_over_a_needle() {
  TetMesh mesh;
  mesh.nodes = {{-0.555, -0.104, -0.054}, {0.456, -0.284, -0.079}, {0.455, 0.735, -0.079},
                {-0.041, -0.136, -0.014}, {-0.251, 0.047, 0.074},  {0.365, 0.057, 0.148},
                {0.474, -0.23, 0.033},    {-0.028, 0.034, 0.191},  {0.063, 0.025, 0.001}};
  mesh.tets = {{0, 1, 2, 8}, {1, 0, 3, 8}, {8, 0, 3, 4}, {8, 2, 0, 4}, {5, 2, 6, 8}, {6, 8, 7, 5},
               {7, 8, 6, 4}, {3, 6, 8, 4}, {7, 2, 8, 4}, {8, 2, 7, 5}, {2, 1, 6, 8}, {1, 3, 6, 8}};
  mesh.boundary_nodes = 8;
  return mesh;
}

struct Raised {
  double lowest2 = 0;
  double worst = 0;
};

/// A mesh of one inner node, the last, that was moved to where the worst tet round it is best, and
/// then to where the lowest is highest.
Raised raised_round_one_node(const TetMesh& mesh, double traded_quality) {
  TetComplex complex = make_tet_complex(mesh);
  const std::int32_t node = mesh.boundary_nodes;
  WorkMesh work(complex, node);
  const std::vector<std::int32_t> ball = ball_of_node(work, node);
  while (const auto place = find_move(work, ball, node, 1)) {
    move_node(work, ball, node, place->point);
  }
  HeightOptions options = wanting(1, 1);
  options.most_joint_failures = 1;
  options.traded_quality = traded_quality;
  improve_altitudes(work, options);
  EXPECT_THAT(validate(complex), IsEmpty());
  return {lowest2(work), worst_quality(work)};
}

TEST(AltitudeImprovement, a_stuck_tet_is_raised_for_a_third_as_much_of_the_angle_at_most) {
  const Raised kept = raised_round_one_node(tets_over_a_needle(), 0);
  const Raised sold = raised_round_one_node(tets_over_a_needle(), 1);
  EXPECT_GT(sold.lowest2, 1.1 * kept.lowest2);
  EXPECT_LT(sold.worst, 0.98 * kept.worst);
  EXPECT_GT(std::pow(sold.worst / kept.worst, 3) * sold.lowest2 / kept.lowest2, 1.03);
}

TEST(AltitudeImprovement, no_angle_is_sold_for_less_than_three_times_as_much_of_the_height) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    TetMesh mesh = trial::kuhn_box(2, 0.5);
    for (std::size_t v = 0; v < mesh.nodes.size(); ++v) {
      mesh.nodes[v] += 0.8 * trial::random_vector(seed, v);
      mesh.nodes[v].z *= 0.3;
    }
    if (!validate(make_tet_complex(mesh)).empty()) continue;
    const Raised kept = raised_round_one_node(mesh, 0);
    const Raised sold = raised_round_one_node(mesh, 1);
    EXPECT_GE(std::pow(sold.worst / kept.worst, 3) * sold.lowest2 / kept.lowest2, 1) << seed;
  }
}

TEST(AltitudeImprovement, angles_that_are_not_below_the_limit_are_not_sold) {
  const TetMesh mesh = tets_over_a_needle();
  const double kept = raised_round_one_node(mesh, 0).worst;
  EXPECT_EQ(raised_round_one_node(mesh, 0.999 * kept).worst, kept);
  EXPECT_LT(raised_round_one_node(mesh, 1.001 * kept).worst, kept);
}

TEST(AltitudeImprovement, a_low_tet_is_as_high_as_is_wanted_where_spacings_are_small) {
  const TetMesh mesh = trial::kuhn_box(6, 0.6, 3);
  TetComplex complex = make_tet_complex(mesh);
  WorkMesh work(complex, mesh.boundary_nodes);
  HeightOptions options;
  options.wanted_spacings = 0.45;
  options.spacing = [](const Vec3& p) { return p.x < 3 ? 0.001 : 1.0; };
  EXPECT_GT(improve_altitudes(work, options), 5);
  for (std::size_t v = 0; v < mesh.nodes.size(); ++v) {
    if (mesh.nodes[v].x < 1.5) {
      EXPECT_EQ(complex.points[v], mesh.nodes[v]);
    }
  }
}

}  // namespace
}  // namespace tetfarm::cosmetics
