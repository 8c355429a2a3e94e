#include "mesh/assimilation/group_refinement.h"

#include <gmock/gmock.h>

#include "mesh/assimilation/assimilation.h"
#include "tests/mesh/assimilation/leaf_graphs.h"

namespace tetfarm {
namespace {

using ::testing::Each;
using ::testing::ElementsAre;

/// A row of leaves, each touching the next.
SubdomainGraph row(std::size_t count) {
  SubdomainGraph graph = test::unconnected_leaves(count);
  for (std::size_t i = 0; i + 1 < count; ++i) {
    test::connect(graph, static_cast<std::int32_t>(i), static_cast<std::int32_t>(i + 1), 5);
  }
  return graph;
}

std::int32_t group_count(const std::vector<std::int32_t>& leaf2group) {
  return 1 + *std::max_element(leaf2group.begin(), leaf2group.end());
}

TEST(GroupRefinement, knows_a_group_in_two_pieces) {
  const std::vector<std::int32_t> apart = {0, 1, 0};
  EXPECT_FALSE(groups_are_connected(row(3), apart));
  const std::vector<std::int32_t> together = {0, 0, 1};
  EXPECT_TRUE(groups_are_connected(row(3), together));
}

TEST(GroupRefinement, a_piece_that_hangs_on_nothing_goes_to_a_neighbour) {
  const std::vector<std::int32_t> split = {0, 0, 1, 1, 0, 1};
  const std::vector<std::int32_t> refined = refine_groups(row(6), split, {.balanced = 10});
  EXPECT_TRUE(groups_are_connected(row(6), refined));
  EXPECT_THAT(refined, ElementsAre(0, 0, 1, 1, 1, 1));
}

TEST(GroupRefinement, leaves_move_until_the_work_is_even) {
  const std::vector<std::int32_t> uneven = {0, 0, 0, 0, 0, 1};
  EXPECT_THAT(refine_groups(row(6), uneven), ElementsAre(0, 0, 0, 1, 1, 1));
}

TEST(GroupRefinement, leaves_change_places_where_a_move_does_not_help) {
  SubdomainGraph graph = test::unconnected_leaves(4);
  for (const auto& [a, b] : {std::pair{0, 1}, {2, 3}, {0, 2}, {1, 3}, {0, 3}, {1, 2}}) {
    test::connect(graph, a, b, 5);
  }
  graph.work = {70, 70, 40, 40};
  const std::vector<std::int32_t> refined =
      refine_groups(graph, std::vector<std::int32_t>{0, 0, 1, 1});
  EXPECT_THAT(sums_of_groups(graph.work, refined), Each(110));
}

TEST(GroupRefinement, an_empty_group_gets_leaves) {
  const std::vector<std::int32_t> refined =
      refine_groups(row(6), std::vector<std::int32_t>{0, 0, 0, 2, 2, 2});
  EXPECT_EQ(group_count(refined), 3);
  EXPECT_THAT(sums_of_groups(row(6).work, refined), Each(::testing::Ge(100)));
  EXPECT_TRUE(groups_are_connected(row(6), refined));
}

TEST(GroupRefinement, no_group_spans_two_pieces_of_the_domain) {
  const SubdomainGraph apart = test::unconnected_leaves(3);
  EXPECT_THAT(refine_groups(apart, std::vector<std::int32_t>{0, 0, 1}), ElementsAre(0, 1, 2));
}

TEST(GroupRefinement, groups_are_numbered_by_their_first_leaves) {
  EXPECT_THAT(refine_groups(row(4), std::vector<std::int32_t>{1, 1, 0, 0}),
              ElementsAre(0, 0, 1, 1));
}

TEST(GroupRefinement, random_groups_of_uneven_leaves_become_connected_and_even) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const SubdomainGraph graph = test::uneven_grid(5, 1.5, seed);
    std::mt19937_64 random(seed);
    std::vector<std::int32_t> scattered(graph.size());
    for (std::int32_t& group : scattered) group = static_cast<std::int32_t>(random() % 8);
    const std::vector<std::int32_t> refined = refine_groups(graph, scattered);
    EXPECT_TRUE(groups_are_connected(graph, refined)) << "seed " << seed;
    EXPECT_EQ(group_count(refined), 8) << "seed " << seed;
    EXPECT_LE(balance_of(sums_of_groups(graph.work, refined)).ratio(), 1.05) << "seed " << seed;
    EXPECT_EQ(refined, refine_groups(graph, scattered)) << "the same each time";
  }
}

}  // namespace
}  // namespace tetfarm
