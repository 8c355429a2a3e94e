#include "mesh/partition/node_order.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/mesh/formats/grid_source.h"

namespace tetfarm {
namespace {

TEST(NumberSpans, of_several_parts_have_the_largest_bandwidth_and_all_edges) {
  const NumberSpans narrow{10, 3, 20};
  const NumberSpans wide{5, 40, 100};
  for (const bool is_wide_first : {false, true}) {
    NumberSpans both = is_wide_first ? wide : narrow;
    both.add(is_wide_first ? narrow : wide);
    EXPECT_EQ(both.bandwidth, 40);
    EXPECT_EQ(both.edges, 15);
    EXPECT_EQ(both.mean(), 8);
  }
}

TEST(NumberSpans, count_each_edge_of_the_cells_once) {
  NumberedPart part;
  part.nodes.resize(6);
  part.tets = {{0, 1, 2, 3}, {1, 2, 3, 5}};
  const NumberSpans spans = number_spans(part);
  EXPECT_EQ(spans.edges, 9);
  EXPECT_EQ(spans.bandwidth, 4);
  EXPECT_EQ(spans.sum, 1 + 2 + 3 + 1 + 2 + 1 + 4 + 3 + 2);
}

TEST(ReverseCuthillMckee, is_an_order_of_all_nodes_in_which_neighbours_are_near) {
  const NumberedPart part = GridSource(cut_grid(6)).parts[0];
  const std::vector<std::int32_t> order = reverse_cuthill_mckee(part);
  std::vector<std::int32_t> sorted = order;
  std::ranges::sort(sorted);
  ASSERT_EQ(order.size(), part.nodes.size());
  for (std::size_t v = 0; v < sorted.size(); ++v)
    EXPECT_EQ(sorted[v], static_cast<std::int32_t>(v));
  std::vector<std::int32_t> place(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) place[at(order[i])] = static_cast<std::int32_t>(i);
  NumberedPart renumbered = part;
  for (Tet& tet : renumbered.tets) {
    for (std::int32_t& v : tet) v = place[at(v)];
  }
  EXPECT_LT(number_spans(renumbered).bandwidth, number_spans(part).bandwidth);
}

}  // namespace
}  // namespace tetfarm
