#include "mesh/layers/top_jumps.h"

#include <gmock/gmock.h>

namespace tetfarm {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;
using testing::IsEmpty;

/// Two tets, 3 and 6 high, on a triangle of the top and on one that has a vertex of the surface; a
/// third between them that stands on none.
struct Tets {
  TetMesh mesh;
  std::vector<Origin> origins = {
      {top_of_layers, 4}, {top_of_layers, 2}, {top_of_layers, 9}, {0, 3}, {5, 0}, {5, 1}};
  std::vector<TopHeight> heights = {{{2, 4, 9}, 1.5}, {{2, 9, (std::uint64_t{1} << 32U) + 3}, 2}};

  Tets() {
    mesh.nodes = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 0, 3}, {1, 1, 6}};
    mesh.tets = {{0, 1, 2, 4}, {5, 1, 3, 2}, {1, 2, 4, 5}};
  }
};

TEST(TopJumps, are_heights_of_tets_over_those_of_the_prisms_below) {
  const Tets tets;
  EXPECT_THAT(top_jumps(tets.mesh, tets.origins, tets.heights),
              ElementsAre(DoubleNear(2, 1e-14), DoubleNear(3, 1e-14)));
}

TEST(TopJumps, are_none_where_no_prism_is_below) {
  Tets tets;
  tets.heights.erase(tets.heights.begin());
  EXPECT_THAT(top_jumps(tets.mesh, tets.origins, tets.heights), ElementsAre(DoubleNear(3, 1e-14)));
  EXPECT_THAT(top_jumps(tets.mesh, tets.origins, {}), IsEmpty());
}

TEST(TopJumps, need_no_origins_of_nodes_inside) {
  Tets tets;
  tets.origins.resize(4);
  EXPECT_EQ(top_jumps(tets.mesh, tets.origins, tets.heights).size(), 2U);
}

TEST(TopJumps, ask_for_triangles_by_the_nodes_of_the_top_alone) {
  EXPECT_THAT(firsts_of_top(Tets().origins), ElementsAre(2, 4, 9));
  EXPECT_THAT(firsts_of_top(std::vector<Origin>{{0, 1}, {7, 1}}), IsEmpty());
}

}  // namespace
}  // namespace tetfarm
