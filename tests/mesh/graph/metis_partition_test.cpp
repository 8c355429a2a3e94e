#include "mesh/graph/metis_partition.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "tests/mesh/graph/graph_grid.h"

namespace tetfarm {
namespace {

/// The pieces of parts, of which there should be as many as parts.
std::int32_t pieces(const WeightedGraph& graph, const std::vector<std::int32_t>& parts) {
  const std::vector<std::int32_t> piece = pieces_of_parts(graph, parts);
  return *std::max_element(piece.begin(), piece.end()) + 1;
}

TEST(MetisPartition, has_parts_of_one_piece_where_that_is_asked_for) {
  std::int32_t torn = 0;
  for (std::uint32_t seed = 0; seed < 40; ++seed) {
    WeightedGraph graph = test::graph_grid(12);
    std::mt19937 random(seed);
    for (std::int32_t& weight : graph.weight) weight = 1 + static_cast<std::int32_t>(random() % 50);
    MetisOptions options;
    options.imbalance_in_thousandths = 5;
    torn += pieces(graph, metis_partition(graph, 9, options)) > 9 ? 1 : 0;
    options.contiguous = true;
    EXPECT_EQ(pieces(graph, metis_partition(graph, 9, options)), 9) << seed;
  }
  EXPECT_GT(torn, 0) << "else the option would do nothing";
}

TEST(MetisPartition, gives_each_node_a_part_of_its_own_where_there_are_as_many) {
  const WeightedGraph graph = test::graph_grid(2);
  EXPECT_EQ(metis_partition(graph, 1, {}), (std::vector<std::int32_t>{0, 0, 0, 0}));
  EXPECT_EQ(metis_partition(graph, 4, {}), (std::vector<std::int32_t>{0, 1, 2, 3}));
}

}  // namespace
}  // namespace tetfarm
