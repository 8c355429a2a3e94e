#include "mesh/partition/node_order.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <set>

#include "base/array_index.h"
#include "mesh/assemble/part_edges.h"
#include "tests/mesh/formats/grid_source.h"
#include "tests/support/hybrid_grid.h"

namespace tetfarm {
namespace {

TEST(NodeOrder, reverse_cuthill_mckee_narrows_the_band_of_a_shuffled_mesh) {
  const GridSource grid(cut_grid(8));
  NumberedPart part = grid.part(0);
  const auto nodes = static_cast<std::int64_t>(part.nodes.size());
  const auto shuffled = [&](std::int32_t v) {
    return static_cast<std::int32_t>((static_cast<std::int64_t>(v) * 7919) % nodes);
  };
  ASSERT_NE(nodes % 7919, 0);
  for (Tet& tet : part.tets) {
    for (std::int32_t& v : tet) v = shuffled(v);
  }
  const std::vector<std::int32_t> order = reverse_cuthill_mckee(part);
  std::vector<std::int32_t> old2new(order.size(), -1);
  for (std::size_t v = 0; v < order.size(); ++v) {
    old2new[static_cast<std::size_t>(order[v])] = static_cast<std::int32_t>(v);
  }
  EXPECT_THAT(old2new, testing::Each(testing::Ge(0))) << "every node once";
  const NumberSpans before = number_spans(part);
  for (Tet& tet : part.tets) {
    for (std::int32_t& v : tet) v = old2new[static_cast<std::size_t>(v)];
  }
  const NumberSpans after = number_spans(part);
  EXPECT_EQ(after.edges, before.edges);
  EXPECT_LT(3 * after.bandwidth, before.bandwidth);
}

TEST(NodeOrder, of_pieces_and_single_nodes_has_all_of_them) {
  NumberedPart part;
  part.nodes.resize(9);
  part.tets = {{0, 1, 2, 3}, {5, 6, 7, 8}};
  std::vector<std::int32_t> order = reverse_cuthill_mckee(part);
  std::sort(order.begin(), order.end());
  EXPECT_THAT(order, testing::ElementsAre(0, 1, 2, 3, 4, 5, 6, 7, 8));
}

TEST(NodeOrder, spans_are_of_each_edge_once) {
  NumberedPart part;
  part.nodes.resize(11);
  part.tets = {{0, 1, 2, 3}, {1, 2, 3, 10}};
  const NumberSpans spans = number_spans(part);
  EXPECT_EQ(spans.edges, 9);
  EXPECT_EQ(spans.bandwidth, 9);
  EXPECT_EQ(spans.sum, (1 + 2 + 3 + 1 + 2 + 1) + (9 + 8 + 7));
}

/// A strip of tets, each with the next three nodes.
NumberedPart strip(std::int32_t nodes, const std::vector<std::int32_t>& number) {
  NumberedPart part;
  part.nodes.resize(at(nodes));
  for (std::int32_t v = 0; v + 3 < nodes; ++v) {
    part.tets.push_back({number[at(v)], number[at(v + 1)], number[at(v + 2)], number[at(v + 3)]});
  }
  return part;
}

TEST(NodeOrder, finds_a_shuffled_strip_from_end_to_end) {
  constexpr std::int32_t nodes = 50;
  std::vector<std::int32_t> number(nodes);
  std::iota(number.begin(), number.end(), 0);
  std::shuffle(number.begin(), number.end(), std::mt19937(3));
  std::vector<std::int32_t> order = reverse_cuthill_mckee(strip(nodes, number));
  if (order.front() != number.front()) std::reverse(order.begin(), order.end());
  EXPECT_EQ(order, number);
}

TEST(NodeOrder, is_the_reverse_of_a_breadth_first_order_by_degree) {
  const NumberedPart part = HybridGrid(3, 1).part(0);
  std::vector<std::set<std::int32_t>> neighbours(part.nodes.size());
  for (const auto& [a, b] : edges_of(part)) {
    neighbours[at(a)].insert(b);
    neighbours[at(b)].insert(a);
  }
  const auto by_degree = [&](std::int32_t a, std::int32_t b) {
    return std::pair(neighbours[at(a)].size(), a) < std::pair(neighbours[at(b)].size(), b);
  };
  const std::vector<std::int32_t> order = reverse_cuthill_mckee(part);
  std::vector<std::int32_t> expected = {order.back()};
  std::set<std::int32_t> seen = {order.back()};
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const std::set<std::int32_t>& around = neighbours[at(expected[i])];
    std::vector<std::int32_t> next(around.begin(), around.end());
    std::erase_if(next, [&](std::int32_t v) { return !seen.insert(v).second; });
    std::sort(next.begin(), next.end(), by_degree);
    expected.insert(expected.end(), next.begin(), next.end());
  }
  std::reverse(expected.begin(), expected.end());
  EXPECT_EQ(order, expected);
}

TEST(NodeOrder, spans_of_a_hex_are_not_across_its_quads) {
  NumberedPart part;
  part.nodes.resize(8);
  part.blocks[ElementType::hex].nodes = {0, 1, 2, 3, 4, 5, 6, 7};
  part.blocks[ElementType::hex].regions = {1};
  const NumberSpans spans = number_spans(part);
  EXPECT_EQ(spans.edges, 12);
  EXPECT_EQ(spans.bandwidth, 4);
  EXPECT_EQ(spans.sum, 2 * (1 + 1 + 1 + 3) + 4 * 4);
}

TEST(NodeOrder, spans_of_parts_add_up_to_those_of_all) {
  NumberSpans spans;
  EXPECT_EQ(spans.mean(), 0);
  spans.add({2, 9, 10});
  spans.add({3, 5, 10});
  EXPECT_EQ(spans.edges, 5);
  EXPECT_EQ(spans.bandwidth, 9);
  EXPECT_EQ(spans.mean(), 4);
}

}  // namespace
}  // namespace tetfarm
