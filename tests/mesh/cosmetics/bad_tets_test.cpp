#include "mesh/cosmetics/bad_tets.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/array_index.h"
#include "mesh/cosmetics/quality.h"

namespace tetfarm::cosmetics {
namespace {

/// Three regular tets apart from each other, then a flat one.
TetComplex three_regular_and_a_flat_one() {
  TetMesh mesh;
  for (int i = 0; i < 4; ++i) {
    const Vec3 shift{10.0 * i, 0, 0};
    const double height = i < 3 ? 1 : 0.1;
    for (const Vec3& corner :
         {Vec3{1, 1, height}, Vec3{-1, 1, -height}, Vec3{1, -1, -height}, Vec3{-1, -1, height}}) {
      mesh.nodes.push_back(corner + shift);
    }
    mesh.tets.push_back({4 * i, 4 * i + 1, 4 * i + 2, 4 * i + 3});
  }
  return make_tet_complex(mesh);
}

CosmeticOptions options_with(const RegularTets& regular) {
  CosmeticOptions options;
  options.measures_angles = true;
  options.regular = regular;
  return options;
}

TEST(ScanForBadTets, measures_one_regular_tet_for_all) {
  const TetComplex complex = three_regular_and_a_flat_one();
  TetComplex regular_alone = complex;
  regular_alone.kill_tet(3);
  const BadTetScan scan = scan_for_bad_tets(regular_alone, {0.1, 0}, options_with({0, 3, 1}));
  EXPECT_NEAR(scan.min_dihedral_deg, 70.528779365509308, 1e-9);
  EXPECT_FALSE(std::isnan(scan.tet2quality[0]));
  EXPECT_TRUE(std::isnan(scan.tet2quality[1]));
  EXPECT_TRUE(std::isnan(scan.tet2quality[2]));
}

TEST(ScanForBadTets, names_those_below_the_limit_and_the_nodes_to_relax) {
  const TetComplex complex = three_regular_and_a_flat_one();
  const BadTetScan scan = scan_for_bad_tets(complex, {0.1, 0.2}, options_with({}));
  ASSERT_EQ(scan.bad.size(), 1U);
  EXPECT_EQ(scan.bad[0].tet, 3);
  EXPECT_EQ(scan.bad[0].quality, quality(complex, complex.nodes[3]));
  for (std::size_t v = 0; v < 16; ++v) EXPECT_EQ(scan.to_relax.at(v), v >= 12) << v;
  EXPECT_TRUE(scan_for_bad_tets(complex, {0, 0}, options_with({})).to_relax.empty());
}

}  // namespace
}  // namespace tetfarm::cosmetics
