#include "mesh/cosmetics/subdomain_colouring.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>
#include <set>

#include "tests/mesh/cosmetics/cut_bar.h"
#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

InterfaceNodes nodes_of(std::uint64_t heap, std::vector<std::uint32_t> indices) {
  InterfaceNodes leaf{{heap}, {}};
  for (const std::uint32_t index : indices) leaf.nodes.push_back({1, index});
  return leaf;
}

std::vector<std::uint64_t> heaps(const std::vector<TreePath>& paths) {
  std::vector<std::uint64_t> numbers;
  for (const TreePath path : paths) numbers.push_back(path.heap);
  return numbers;
}

TEST(SubdomainColouring, leaves_in_a_row_take_turns_with_two_colours) {
  const CosmeticOrder order = colour_subdomains(
      {nodes_of(4, {1}), nodes_of(5, {1, 2}), nodes_of(6, {2, 3}), nodes_of(7, {3})});
  std::vector<std::int32_t> colours;
  for (const ColouredLeaf& leaf : order.leaves) colours.push_back(leaf.colour);
  EXPECT_THAT(colours, ElementsAre(0, 1, 0, 1));
  EXPECT_THAT(heaps(order.leaves[1].neighbours), ElementsAre(4, 6));
}

TEST(SubdomainColouring, the_top_of_layers_is_no_interface) {
  Subdomain leaf = root_subdomain(shapes::unit_cube());
  for (Origin& origin : leaf.triangle_origin) origin.owner = top_of_layers;
  EXPECT_THAT(interface_nodes(leaf).nodes, IsEmpty());
  leaf.triangle_origin[0].owner = 2;
  EXPECT_THAT(interface_nodes(leaf).nodes, SizeIs(3));
}

TEST(SubdomainColouring, one_common_node_makes_neighbours) {
  const CosmeticOrder order = colour_subdomains(
      {nodes_of(4, {1}), nodes_of(5, {1}), nodes_of(6, {1, 9}), nodes_of(7, {9})});
  EXPECT_THAT(heaps(order.leaves[0].neighbours), ElementsAre(5, 6));
  EXPECT_THAT(heaps(order.leaves[3].neighbours), ElementsAre(6));
  EXPECT_EQ(order.leaves[2].colour, 2);
  EXPECT_EQ(order.leaves[3].colour, 0);
}

TEST(SubdomainColouring, nodes_know_all_who_share_them) {
  const CosmeticOrder order = colour_subdomains(
      {nodes_of(4, {1, 2, 8}), nodes_of(5, {1, 2}), nodes_of(6, {2}), nodes_of(7, {})});
  const SharedNodes& shared = order.shared[0];
  EXPECT_THAT(shared.sets, ElementsAre(Sharers{4, 5}, Sharers{4, 5, 6}));
  ASSERT_THAT(shared.nodes, SizeIs(2)) << "node 8 is nobody else's";
  EXPECT_EQ(shared.nodes[0].origin.index, 1U);
  EXPECT_EQ(shared.sets[shared.nodes[0].set], (Sharers{4, 5}));
  EXPECT_EQ(shared.sets[shared.nodes[1].set], (Sharers{4, 5, 6}));
  EXPECT_THAT(order.shared[3].nodes, IsEmpty());
  EXPECT_THAT(order.leaves[3].neighbours, IsEmpty());
}

TEST(SubdomainColouring, nodes_of_one_number_that_different_cuts_made_are_different) {
  const std::uint64_t deep = std::uint64_t{1} << 40U;
  const CosmeticOrder order = colour_subdomains(
      {{{4}, {{0, 1}, {3, 1}, {deep, 1}}}, {{5}, {{3, 1}}}, {{6}, {{0, 1}}}, {{7}, {{2, 1}}}});
  EXPECT_THAT(heaps(order.leaves[0].neighbours), ElementsAre(5, 6));
  EXPECT_THAT(heaps(order.leaves[1].neighbours), ElementsAre(4));
  EXPECT_THAT(order.leaves[3].neighbours, IsEmpty());
  const SharedNodes& shared = order.shared[0];
  ASSERT_THAT(shared.nodes, SizeIs(2));
  EXPECT_EQ(shared.nodes[0].origin, (Origin{0, 1}));
  EXPECT_EQ(shared.nodes[1].origin, (Origin{3, 1}));
}

TEST(SubdomainColouring, does_not_depend_on_the_order_of_the_leaves) {
  std::vector<InterfaceNodes> leaves = {nodes_of(4, {1}), nodes_of(5, {1, 2}), nodes_of(6, {2, 3})};
  const CosmeticOrder once = colour_subdomains(leaves);
  std::reverse(leaves.begin(), leaves.end());
  const CosmeticOrder again = colour_subdomains(leaves);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(once.leaves[i].path, again.leaves[i].path);
    EXPECT_EQ(once.leaves[i].colour, again.leaves[i].colour);
    EXPECT_EQ(once.shared[i].sets, again.shared[i].sets);
  }
}

TEST(SubdomainColouring, neighbours_never_have_the_same_colour_and_colours_are_few) {
  for (std::uint32_t seed = 1; seed <= 50; ++seed) {
    std::mt19937 random(seed);
    std::vector<InterfaceNodes> leaves;
    for (std::uint64_t heap = 32; heap < 64; ++heap) {
      std::set<std::uint32_t> nodes;
      for (int i = 0; i < 6; ++i) nodes.insert(static_cast<std::uint32_t>(random() % 90));
      leaves.push_back(nodes_of(heap, {nodes.begin(), nodes.end()}));
    }
    const CosmeticOrder order = colour_subdomains(leaves);
    std::map<std::uint64_t, const ColouredLeaf*> by_heap;
    for (const ColouredLeaf& leaf : order.leaves) by_heap[leaf.path.heap] = &leaf;
    for (const ColouredLeaf& leaf : order.leaves) {
      EXPECT_LE(leaf.colour, std::ssize(leaf.neighbours)) << seed;
      for (const TreePath other : leaf.neighbours) {
        const ColouredLeaf& neighbour = *by_heap.at(other.heap);
        EXPECT_NE(neighbour.colour, leaf.colour) << seed;
        EXPECT_THAT(heaps(neighbour.neighbours), testing::Contains(leaf.path.heap)) << seed;
      }
    }
    for (const SharedNodes& shared : order.shared) {
      for (const Sharers& sharers : shared.sets) {
        std::set<std::int32_t> colours;
        for (const std::uint64_t heap : sharers) colours.insert(by_heap.at(heap)->colour);
        EXPECT_EQ(colours.size(), sharers.size()) << "sharers have their turns one by one";
      }
    }
  }
}

TEST(SubdomainColouring, corners_of_a_cut_bar_make_neighbours_by_edge_and_node) {
  const trial::CutBar bar({4, 4, 4}, [](const trial::Cell& cell) {
    return std::uint64_t{8} +
           static_cast<std::uint64_t>(4 * (cell[0] / 2) + 2 * (cell[1] / 2) + cell[2] / 2);
  });
  std::vector<InterfaceNodes> leaves;
  for (const auto& [heap, part] : bar.parts) leaves.push_back(interface_nodes(part.leaf));
  const CosmeticOrder order = colour_subdomains(leaves);
  ASSERT_THAT(order.leaves, SizeIs(8));
  for (const ColouredLeaf& leaf : order.leaves) EXPECT_THAT(leaf.neighbours, SizeIs(7));
  // Three faces, three edges, one corner.
  for (const SharedNodes& shared : order.shared) EXPECT_THAT(shared.sets, SizeIs(7));
}

}  // namespace
}  // namespace tetfarm
