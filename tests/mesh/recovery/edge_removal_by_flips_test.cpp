#include "mesh/recovery/edge_removal_by_flips.h"

#include <gtest/gtest.h>

#include <random>

#include "mesh/geometry/bowyer_watson.h"

namespace tetfarm {
namespace {

DelaunayTets random_tets(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> place(0, 1);
  std::vector<Vec3> points(30);
  for (Vec3& p : points) p = {place(random), place(random), place(random)};
  return bowyer_watson(points);
}

/// Of the inner edges those that are removed, each from the same tets.
int removed_edges(const TetComplex& tets, int depth) {
  int removed = 0;
  for (std::int32_t a = 0; a < 30; ++a) {
    for (std::int32_t b = a + 1; b < 30; ++b) {
      TetComplex complex = tets;
      std::vector<std::uint8_t> constrained(complex.nodes.size(), 0);
      LocalRemeshing mesh(complex, constrained);
      if (!mesh.ring(a, b)) continue;
      const RecoverySurface no_surface({}, 30);
      EdgeRemoval removal(mesh, no_surface);
      removal.set_budget(1'000);
      const bool is_gone = removal.remove(a, b, RecoveryGuard::of_nothing(mesh), depth);
      EXPECT_EQ(is_gone, mesh.find_edge(a, b) < 0);
      EXPECT_TRUE(validate(complex).empty());
      removed += is_gone ? 1 : 0;
    }
  }
  return removed;
}

TEST(EdgeRemoval, goes_into_what_hides_an_apex_as_deep_as_it_is_told_to) {
  int shallow = 0;
  int deep = 0;
  for (std::uint64_t seed = 0; seed < 3; ++seed) {
    const TetComplex tets = random_tets(seed).complex;
    shallow += removed_edges(tets, 0);
    deep += removed_edges(tets, 2);
  }
  EXPECT_GT(shallow, 100);
  EXPECT_GT(deep, shallow);
}

}  // namespace
}  // namespace tetfarm
