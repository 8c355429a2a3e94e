#include "mesh/decompose/split_subdomain.h"

#include <gtest/gtest.h>

#include "tests/mesh/decompose/flat_cut.h"

namespace tetfarm {
namespace {

TEST(SplitSubdomain, keeps_old_origins_and_numbers_new_ones_from_zero) {
  const FlatCut cut = cap_of_sphere();
  const std::size_t new_nodes = cut.mesh.planar.points.size() - cut.mesh.rim_vertices.size();
  for (const Side side : {Side::left, Side::right}) {
    const Subdomain half = half_of(cut.subdomain, cut.colours, cut.mesh, side);
    EXPECT_TRUE(validate(half).empty());
    std::size_t seen = 0;
    for (std::size_t v = 0; v < half.vertices.size(); ++v) {
      if (half.node_origin[v].owner == 0) {
        EXPECT_EQ(half.vertices[v], cut.subdomain.vertices[half.node_origin[v].index]);
      } else {
        EXPECT_EQ(half.node_origin[v], (Origin{1, static_cast<std::uint32_t>(seen++)}));
      }
    }
    EXPECT_EQ(seen, new_nodes);
  }
}

TEST(SplitSubdomain, leaves_both_halves_in_the_region_of_the_whole) {
  FlatCut cut = cap_of_sphere();
  cut.subdomain.region = 3;
  cut.subdomain.path = TreePath{5};
  for (const Side side : {Side::left, Side::right}) {
    const Subdomain half = half_of(cut.subdomain, cut.colours, cut.mesh, side);
    EXPECT_EQ(half.region, 3);
    EXPECT_EQ(half.path.heap, side == Side::left ? 10U : 11U);
  }
}

}  // namespace
}  // namespace tetfarm
