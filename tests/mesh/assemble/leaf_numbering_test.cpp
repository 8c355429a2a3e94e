#include "mesh/assemble/leaf_numbering.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "base/error.h"
#include "tests/mesh/assemble/random_numbering.h"

namespace tetfarm {
namespace {

using testing::ElementsAre;

constexpr const char* table =
    "cut 1 10\ncut 2 20\ncut 3 30\nleaf 4 40 400 4\nleaf 5 50 500 5\njoined 6 4\nleaf 7 70 700 3\n"
    "dropped 1 2 2\ndropped 5 1 19\n";

TEST(LeafNumbering, tells_the_leaf_its_place_and_the_sizes_of_the_whole) {
  const Numbering numbering = number_globally(shapes::unit_cube(), table);
  const std::vector<Origin> nodes = {{1, 4}, {0, 7}, {5, 0}, {0, 7}};
  const LeafNumbering leaf = leaf_numbering(numbering, {{5}, 1, nodes});
  EXPECT_EQ(leaf.number, 1);
  EXPECT_EQ(leaf.first_node, 8 + 8 + 20 + 30 + 40);
  EXPECT_EQ(leaf.kept_nodes, 31);
  EXPECT_EQ(leaf.tets, 500);
  EXPECT_EQ(leaf.first_tet, 400);
  EXPECT_EQ(leaf.first_face, 4);
  EXPECT_THAT(leaf.node_numbers, ElementsAre(8 + 2, 7, leaf.first_node, 7));
  EXPECT_EQ(leaf.whole, (MeshTotals{3, 1600, 12, 1}));
}

TEST(LeafNumbering, knows_no_first_face_where_not_all_were_counted) {
  const Numbering numbering = number_globally(
      shapes::unit_cube(), "cut 1 5\ncut 3 0\nleaf 2 6 30 7\nleaf 6 1 1\nleaf 7 1 1\n");
  for (const std::uint64_t leaf : {2U, 6U, 7U}) {
    EXPECT_EQ(leaf_numbering(numbering, {{leaf}, 1, {}}).first_face, std::nullopt) << leaf;
  }
}

TEST(LeafNumbering, of_layers_tells_of_cells_of_every_type_and_forces_the_top) {
  const Numbering numbering =
      number_globally(shapes::unit_cube(), "cut 1 9\nleaf 2 6 30\nleaf 3 70 1 8 2 300\n");
  const std::vector<Origin> nodes = {{top_of_layers, 4}, {0, 7}, {3, 69}};
  const LeafNumbering chunk = leaf_numbering(numbering, {{3}, 1, nodes});
  EXPECT_EQ(chunk.others[ElementType::prism], 300);
  EXPECT_EQ(chunk.first_other, ElementCounts{});
  EXPECT_EQ(chunk.whole.others[ElementType::pyramid], 2);
  EXPECT_EQ(chunk.first_tet, 30);
  EXPECT_EQ(chunk.first_face, 4);
  EXPECT_THAT(chunk.node_numbers, ElementsAre(8 + 4, 7, 8 + 9 + 6 + 69));
  EXPECT_THAT(chunk.is_forced, ElementsAre(true, false, false));
}

TEST(LeafNumbering, refuses_what_is_no_leaf_and_no_node) {
  const Numbering numbering = number_globally(shapes::unit_cube(), table);
  for (const std::uint64_t heap : {1U, 2U, 6U, 8U}) {
    EXPECT_THROW(leaf_numbering(numbering, {{heap}, 1, {}}), Error) << heap;
  }
  for (const Origin& origin : {Origin{0, 8}, Origin{1, 3}, Origin{1, 10}, Origin{9, 0}}) {
    EXPECT_THROW(leaf_numbering(numbering, {{4}, 1, std::span(&origin, 1)}), Error);
  }
}

TEST(LeafNumbering, a_node_is_forced_in_the_region_where_the_surface_forces_it) {
  const SurfaceMesh surface = surface_of_two_regions();
  const Numbering numbering = number_globally(surface, "cut 1 0\nleaf 2 0 1\nleaf 3 0 1\n");
  ASSERT_FALSE(numbering.forced.empty());
  std::vector<Origin> nodes;
  for (const ForcedNode& forced : numbering.forced) {
    EXPECT_EQ(forced.region, 1) << "the needles are outside";
    nodes.push_back({0, static_cast<std::uint32_t>(forced.vertex)});
  }
  nodes.push_back({0, 0});
  const LeafNumbering outside = leaf_numbering(numbering, {{2}, 1, nodes});
  EXPECT_EQ(std::count(outside.is_forced.begin(), outside.is_forced.end(), true),
            std::ssize(nodes) - 1);
  EXPECT_FALSE(outside.is_forced.back());
  const LeafNumbering inside = leaf_numbering(numbering, {{3}, 2, nodes});
  EXPECT_EQ(std::count(inside.is_forced.begin(), inside.is_forced.end(), true), 0);
}

}  // namespace
}  // namespace tetfarm
