#include "mesh/cosmetics/relaxation.h"

#include <gmock/gmock.h>

#include "mesh/core/tet_quality.h"
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
  EXPECT_GT(relax_nodes(work, std::vector<bool>(mesh.nodes.size(), true)), 10);
  EXPECT_GT(mean_ratio(complex), ratio + 0.02);
  EXPECT_GE(worst_of(work, all), worst);
  EXPECT_THAT(validate(complex), IsEmpty());
  for (std::size_t v = 0; v < 98; ++v) EXPECT_EQ(complex.points[v], mesh.nodes[v]);
}

TEST(Relaxation, moves_only_nodes_that_are_chosen) {
  const TetMesh mesh = trial::kuhn_box(4, 0.8, 4);
  TetComplex complex = make_tet_complex(mesh);
  WorkMesh work(complex, mesh.boundary_nodes);
  std::vector<bool> chosen(mesh.nodes.size(), false);
  chosen[110] = true;
  relax_nodes(work, chosen);
  for (std::size_t v = 0; v < mesh.nodes.size(); ++v) {
    if (v != 110) {
      EXPECT_EQ(complex.points[v], mesh.nodes[v]);
    }
  }
}

TEST(Relaxation, a_node_in_the_middle_stays) {
  TetComplex complex = make_tet_complex(trial::kuhn_box(2));
  WorkMesh work(complex, 26);
  EXPECT_FALSE(find_rounder_place(work, ball_of_node(work, 26), 26).has_value());
}

}  // namespace
}  // namespace tetfarm::cosmetics
