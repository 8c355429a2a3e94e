#include "mesh/graph/graph_coarsening.h"

#include <gmock/gmock.h>

#include <numeric>

#include "mesh/graph/metis_partition.h"
#include "tests/mesh/graph/graph_grid.h"

namespace tetfarm {
namespace {

/// Of each node of the finest level its node of the coarsest.
std::vector<std::int32_t> clusters_of(const std::vector<GraphLevel>& levels) {
  std::vector<std::int32_t> clusters(levels.front().graph.size());
  std::iota(clusters.begin(), clusters.end(), 0);
  for (std::size_t i = 1; i < levels.size(); ++i) {
    for (std::int32_t& c : clusters) c = levels[i].coarse_of[static_cast<std::size_t>(c)];
  }
  return clusters;
}

TEST(GraphCoarsening, clusters_are_even_whole_and_as_many_as_wanted) {
  const WeightedGraph grid = test::graph_grid(40);
  const std::vector<GraphLevel> levels = coarsen_graph(grid, grid.size(), 100);
  const WeightedGraph& coarse = levels.back().graph;
  EXPECT_LE(coarse.size(), 100u);
  EXPECT_GE(coarse.size(), 50u);
  EXPECT_EQ(std::accumulate(coarse.weight.begin(), coarse.weight.end(), 0), 1600);
  EXPECT_THAT(coarse.weight, testing::Each(testing::Le(2 * 17)));
  const std::vector<std::int32_t> clusters = clusters_of(levels);
  EXPECT_EQ(pieces_of_parts(grid, clusters), clusters);  // numbered by their first nodes, both
}

TEST(GraphCoarsening, every_level_has_the_same_cut_for_the_same_parts) {
  const WeightedGraph grid = test::graph_grid(30);
  const std::vector<GraphLevel> levels = coarsen_graph(grid, grid.size(), 40);
  std::vector<std::int32_t> parts = metis_partition(levels.back().graph, 3, {});
  const std::int64_t cut = edge_cut(levels.back().graph, parts);
  EXPECT_GT(cut, 0);
  std::vector<std::int32_t> fine;
  for (const std::int32_t cluster : clusters_of(levels)) {
    fine.push_back(parts[static_cast<std::size_t>(cluster)]);
  }
  EXPECT_EQ(edge_cut(grid, fine), cut);
}

TEST(GraphCoarsening, what_is_only_seen_changes_nothing_and_stays_single) {
  WeightedGraph grid = test::graph_grid(20);
  const std::vector<std::int32_t> alone = clusters_of(coarsen_graph(grid, grid.size(), 30));
  // The same with one more node, joined with the first.
  const auto more = static_cast<std::int32_t>(grid.size());
  grid.neighbour.insert(grid.neighbour.begin() + grid.first[1], more);
  for (std::size_t v = 1; v < grid.first.size(); ++v) ++grid.first[v];
  grid.neighbour.push_back(0);
  grid.first.push_back(static_cast<std::int32_t>(grid.neighbour.size()));
  grid.edge_weight.assign(grid.neighbour.size(), 1);
  grid.weight.push_back(1);
  const std::vector<GraphLevel> levels = coarsen_graph(grid, grid.size() - 1, 30);
  std::vector<std::int32_t> together = clusters_of(levels);
  EXPECT_EQ(together.back(), static_cast<std::int32_t>(levels.back().movable));
  together.pop_back();
  EXPECT_EQ(together, alone);
}

TEST(GraphCoarsening, never_joins_two_nodes_to_one_that_is_too_heavy) {
  // Two heavy nodes with a heavy edge between them, and twenty light ones in a row.
  WeightedGraph graph;
  graph.weight.assign(22, 1);
  graph.weight[0] = graph.weight[1] = 50;
  make_rows(graph, [](const auto& visit) {
    visit(0, 1, 100);
    for (std::size_t v = 2; v < 22; ++v) visit(v - 1, v, 1);
  });
  for (const GraphLevel& level : coarsen_graph(graph, graph.size(), 5)) {
    // Twice the mean weight that is wanted.
    EXPECT_THAT(level.graph.weight, testing::Each(testing::Le(2 * (120 / 5 + 1)))) << level.movable;
  }
}

}  // namespace
}  // namespace tetfarm
