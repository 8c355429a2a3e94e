#include "mesh/core/tet_layers.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <random>

namespace tetfarm {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// A row of tets, each with three nodes of the one before.
std::vector<Tet> row(std::int32_t tets) {
  std::vector<Tet> row;
  for (std::int32_t t = 0; t < tets; ++t) row.push_back({t, t + 1, t + 2, t + 3});
  return row;
}

TEST(TetLayers, grow_by_the_tets_that_share_a_node) {
  const std::vector<Tet> tets = row(20);
  const TetBlocks blocks(tets, 23);
  TetLayers layers(blocks);
  layers.reach(10);
  EXPECT_THAT(layers.next(), ElementsAre(7, 8, 9, 10));
  for (std::int32_t v = 7; v <= 13; ++v) layers.reach(v);
  EXPECT_THAT(layers.next(), ElementsAre(4, 5, 6, 11, 12, 13));
}

TEST(TetLayers, without_a_new_node_there_is_no_further_layer) {
  const std::vector<Tet> tets = row(20);
  const TetBlocks blocks(tets, 23);
  TetLayers layers(blocks);
  EXPECT_THAT(layers.next(), IsEmpty());
  layers.reach(3);
  layers.next();
  layers.reach(3);
  EXPECT_THAT(layers.next(), IsEmpty());
}

TEST(TetLayers, miss_no_tet_of_a_mesh_in_any_order) {
  std::mt19937 random(7);
  constexpr std::int32_t nodes = 3000;
  std::vector<Tet> tets;
  for (int t = 0; t < 9000; ++t) {
    const auto first = static_cast<std::int32_t>(random() % (nodes - 40));
    tets.push_back({first, first + 1, first + 7, first + 39});
  }
  const TetBlocks blocks(tets, nodes);
  TetLayers layers(blocks);
  std::vector<bool> is_reached(nodes, false);
  std::vector<bool> is_given(tets.size(), false);
  is_reached[1500] = true;
  layers.reach(1500);
  for (int layer = 0; layer < 5; ++layer) {
    std::vector<std::uint32_t> expected;
    for (std::uint32_t t = 0; t < tets.size(); ++t) {
      if (is_given[t] || std::none_of(tets[t].begin(), tets[t].end(), [&](std::int32_t v) {
            return is_reached[static_cast<std::size_t>(v)];
          })) {
        continue;
      }
      is_given[t] = true;
      expected.push_back(t);
    }
    const std::vector<std::uint32_t> found = layers.next();
    EXPECT_EQ(found, expected) << "layer " << layer;
    for (const std::uint32_t t : found) {
      for (const std::int32_t v : tets[t]) {
        is_reached[static_cast<std::size_t>(v)] = true;
        layers.reach(v);
      }
    }
  }
}

}  // namespace
}  // namespace tetfarm
