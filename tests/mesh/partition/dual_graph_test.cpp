#include "mesh/partition/dual_graph.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace tetfarm {
namespace {

using testing::Each;
using testing::ElementsAre;

/// "cell: neighbours; " of each, ascending.
std::string rows_of(const WeightedGraph& graph) {
  std::string text;
  for (std::size_t v = 0; v < graph.size(); ++v) {
    std::vector<std::int32_t> row;
    for (std::size_t e = graph.begin(v); e < graph.end(v); ++e) row.push_back(graph.neighbour[e]);
    std::sort(row.begin(), row.end());
    text += std::to_string(v) + ":";
    for (const std::int32_t other : row) text += " " + std::to_string(other);
    text += "; ";
  }
  return text;
}

TEST(DualGraph, joins_cells_that_share_a_face_and_what_lies_beyond) {
  CellFaces faces;
  faces.inner.resize(3);
  faces.inner[0].owner = 0;
  faces.inner[0].neighbour = 2;
  faces.inner[1].owner = 1;
  faces.inner[1].neighbour = 2;
  faces.inner[2].owner = 2;
  faces.inner[2].neighbour = 3;
  const WeightedGraph graph = dual_graph(faces, 5);
  EXPECT_EQ(rows_of(graph), "0: 2; 1: 2; 2: 0 1 3; 3: 2; 4:; ");
  EXPECT_THAT(graph.weight, ElementsAre(1, 1, 1, 1, 1));
  EXPECT_THAT(graph.edge_weight, Each(1));
  const WeightedGraph beyond = dual_graph(faces, 5, {3, 0, 3});
  EXPECT_EQ(rows_of(beyond), "0: 2 6; 1: 2; 2: 0 1 3; 3: 2 5 7; 4:; 5: 3; 6: 0; 7: 3; ");
  EXPECT_EQ(beyond.weight.size(), 8U);
}

}  // namespace
}  // namespace tetfarm
