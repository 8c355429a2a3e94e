#include "mesh/cosmetics/relaxation.h"

#include <gmock/gmock.h>

#include "base/array_index.h"
#include "mesh/core/tet_quality.h"
#include "mesh/cosmetics/quality.h"
#include "mesh/cosmetics/smoothing.h"
#include "tests/mesh/cosmetics/trial_meshes.h"

namespace tetfarm::cosmetics {
namespace {

using testing::IsEmpty;

double mean_ratio(const TetComplex& complex) {
  double sum = 0;
  for (const Tet& tet : complex.nodes) {
    const auto point = [&](std::size_t i) {
      return complex.points[static_cast<std::size_t>(tet[i])];
    };
    sum += radius_ratio(point(0), point(1), point(2), point(3));
  }
  return sum / static_cast<double>(complex.nodes.size());
}

TEST(Relaxation, makes_tets_rounder_and_the_worst_no_worse) {
  const TetMesh mesh = trial::kuhn_box(4, 0.8, 4);
  TetComplex complex = make_tet_complex(mesh);
  WorkMesh work(complex, mesh.boundary_nodes);
  std::vector<std::int32_t> all;
  for (std::size_t t = 0; t < complex.nodes.size(); ++t) all.push_back(std::int32_t(t));
  const double ratio = mean_ratio(complex);
  const double worst = worst_of(work, all);
  EXPECT_GT(relax_nodes(work, std::vector<bool>(mesh.nodes.size(), true), 1), 10);
  EXPECT_GT(mean_ratio(complex), ratio + 0.02);
  EXPECT_GE(worst_of(work, all), worst);
  EXPECT_THAT(validate(complex), IsEmpty());
  for (std::size_t v = 0; v < 98; ++v) EXPECT_EQ(complex.points[v], mesh.nodes[v]);
}

TEST(Relaxation, goes_down_to_the_floor_and_no_further_for_rounder_tets) {
  const double floor = quality_of_angle(25);
  const TetMesh mesh = trial::kuhn_box(4, 0.5, 4);
  std::array<double, 2> ratio{};
  for (const bool to_floor : {false, true}) {
    TetComplex complex = make_tet_complex(mesh);
    WorkMesh work(complex, mesh.boundary_nodes);
    for (std::size_t v = at(mesh.boundary_nodes); v < mesh.nodes.size(); ++v) {
      const auto ball = ball_of_node(work, static_cast<std::int32_t>(v));
      const auto p = find_rounder_place(work, ball, std::int32_t(v), to_floor ? floor : 1);
      if (!p) continue;
      const double worst = worst_of(work, ball);
      ASSERT_TRUE(move_node(work, ball, static_cast<std::int32_t>(v), *p));
      EXPECT_GE(worst_of(work, ball), to_floor ? std::min(worst, floor) : worst);
    }
    ratio[to_floor ? 1 : 0] = mean_ratio(complex);
  }
  EXPECT_GT(ratio[1], ratio[0]);
}

TEST(Relaxation, moves_only_nodes_that_are_chosen) {
  const TetMesh mesh = trial::kuhn_box(4, 0.8, 4);
  TetComplex complex = make_tet_complex(mesh);
  WorkMesh work(complex, mesh.boundary_nodes);
  std::vector<bool> chosen(mesh.nodes.size(), false);
  chosen[110] = true;
  relax_nodes(work, chosen, 1);
  for (std::size_t v = 0; v < mesh.nodes.size(); ++v) {
    if (v != 110) {
      EXPECT_EQ(complex.points[v], mesh.nodes[v]);
    }
  }
}

TEST(Relaxation, a_node_in_the_middle_stays) {
  TetComplex complex = make_tet_complex(trial::kuhn_box(2));
  WorkMesh work(complex, 26);
  EXPECT_FALSE(find_rounder_place(work, ball_of_node(work, 26), 26, 0).has_value());
}

}  // namespace
}  // namespace tetfarm::cosmetics
