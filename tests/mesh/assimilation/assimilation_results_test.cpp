// Groups of leaves and what is joined of them, known by their digests
// (tests/golden/assimilation.txt). What METIS answers hangs on the C library and is in none.
#include <gmock/gmock.h>

#include "base/error.h"
#include "mesh/assimilation/assimilation.h"
#include "mesh/assimilation/group_refinement.h"
#include "mesh/decompose/planar_cut.h"
#include "tests/mesh/assimilation/leaf_graphs.h"
#include "tests/support/shapes.h"
#include "tests/support/subdomain_digest.h"

namespace tetfarm {
namespace {

using test::ResultDigest;

/// Stripes along the numbers of the leaves, with some out of place.
std::vector<std::int32_t> rough_groups(std::size_t leaves, std::int32_t groups,
                                       std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<std::int32_t> group(leaves);
  for (std::size_t i = 0; i < leaves; ++i) {
    group[i] = static_cast<std::int32_t>(i * static_cast<std::size_t>(groups) / leaves);
    if (random() % 6 == 0) {
      group[i] = static_cast<std::int32_t>(random() % static_cast<std::uint64_t>(groups));
    }
  }
  return group;
}

TEST(AssimilationResults, of_groups_that_are_mended_are_known) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    ResultDigest result;
    const SubdomainGraph graph = test::uneven_grid(4, seed % 2 == 0 ? 3 : 10, seed);
    for (const std::int32_t groups : {2, 5, 9}) {
      const auto rough = rough_groups(graph.size(), groups, seed);
      const auto refined = refine_groups(graph, rough);
      result.add(groups_are_connected(graph, rough), refined);
      RefinementOptions options;
      options.balanced = 1.3;
      result.add(refine_groups(graph, rough, options));
      const std::vector<double> sums = sums_of_groups(graph.work, refined);
      const Balance balance = balance_of(sums);
      result.add(sums, balance.largest, balance.mean, balance.ratio());
    }
    test::expect_known("assimilation", "groups_" + std::to_string(seed), result);
  }
  ResultDigest apart;
  SubdomainGraph pieces = test::unconnected_leaves(9);
  for (const auto& [a, b] : {std::pair{0, 4}, {4, 7}, {1, 2}, {3, 8}, {8, 6}}) {
    test::connect(pieces, a, b, 3);
  }
  apart.add(connected_pieces(pieces), refine_groups(pieces, rough_groups(9, 4, 2)),
            refine_groups(pieces, std::vector<std::int32_t>(9, 0)));
  test::expect_known("assimilation", "pieces", apart);
}

/// A box in four leaves.
std::vector<Subdomain> leaves_of_a_box() {
  const SpacingField spacing(0.25);
  const Subdomain root = root_subdomain(shapes::box({0, 0, 0}, {2, 1.5, 1}, 6));
  const CutOutcome first = planar_cut(root, spacing);
  std::vector<Subdomain> leaves;
  for (const Subdomain& half : {first.cut.value().left, first.cut.value().right}) {
    const CutOutcome second = planar_cut(half, spacing);
    leaves.push_back(second.cut.value().left);
    leaves.push_back(second.cut.value().right);
  }
  return leaves;
}

TEST(AssimilationResults, of_leaves_that_are_joined_are_known) {
  const std::vector<Subdomain> leaves = leaves_of_a_box();
  ResultDigest result;
  SubdomainGraphBuilder builder;
  CutNodeMarks marks;
  for (const Subdomain& leaf : leaves) {
    builder.add(leaf, enclosed_volume(leaf.vertices, leaf.triangles));
    marks.add_leaf(leaf);
    result.add(interface_nodes_of(leaf));
  }
  const SubdomainGraph graph = std::move(builder).finish();
  result.add(graph.work, graph.faces, graph.interface_nodes);
  for (const auto& neighbours : graph.neighbours) {
    for (const Neighbour& n : neighbours) result.add(n.leaf, n.triangles);
  }
  for (const auto& chosen : {std::vector{0, 1}, {2, 3}, {0, 2}, {1, 0, 3}, {0, 1, 2, 3}}) {
    std::vector<Subdomain> some;
    for (const int i : chosen) some.push_back(leaves[static_cast<std::size_t>(i)]);
    test::add_subdomain(result, join_subdomains(some));
  }
  const std::vector<Subdomain> lower = {leaves[0], leaves[1]};
  marks.add_joined(join_subdomains(lower));
  marks.add_joined(leaves[2]);
  marks.add_joined(leaves[3]);
  for (const DroppedNodes& nodes : marks.dropped()) {
    result.add(nodes.cut.heap, nodes.first, nodes.count);
  }
  test::expect_known("assimilation", "joined", result);
}

std::string refusal(const std::vector<Subdomain>& leaves) {
  SubdomainGraphBuilder builder;
  try {
    for (const Subdomain& leaf : leaves) builder.add(leaf, 1);
    std::move(builder).finish();
  } catch (const Error& error) {
    return error.what();
  }
  return "none";
}

TEST(SubdomainGraph, says_which_cut_has_too_few_or_too_many_leaves) {
  std::vector<Subdomain> leaves = leaves_of_a_box();
  EXPECT_EQ(refusal(leaves), "none");
  leaves.push_back(leaves[0]);
  EXPECT_THAT(refusal(leaves),
              testing::MatchesRegex("triangle [0-9]+ of the cut of (root|L) is not shared by two "
                                    "leaves"));
  leaves.pop_back();
  leaves.pop_back();
  EXPECT_THAT(refusal(leaves),
              testing::MatchesRegex("a triangle of the cut of (root|R) has only one leaf"));
}

std::string refusal_to_join(const std::vector<Subdomain>& leaves) {
  try {
    join_subdomains(leaves);
  } catch (const Error& error) {
    return error.what();
  }
  return "none";
}

TEST(JoinSubdomains, says_which_leaf_does_not_fit_and_why) {
  const std::vector<Subdomain> leaves = leaves_of_a_box();
  std::vector<Subdomain> two = {leaves[0], leaves[1]};
  EXPECT_EQ(refusal_to_join(two), "none");
  two[1].region = 2;
  EXPECT_EQ(refusal_to_join(two),
            "the leaves cannot be joined: sub-domain LR: it belongs to another region");
  two = {leaves[0], leaves[1]};
  for (Vec3& p : two[1].vertices) p.x += 1e-9;
  EXPECT_EQ(refusal_to_join(two),
            "the leaves cannot be joined: sub-domain LR: a node is not where another leaf has it");
  two = {leaves[0], leaves[1]};
  for (Triangle& t : two[1].triangles) std::swap(t[0], t[1]);
  EXPECT_EQ(refusal_to_join(two),
            "the leaves cannot be joined: sub-domain LR: a triangle does not match that of another "
            "leaf");
}

TEST(Balance, is_the_largest_over_the_mean) {
  const Balance balance = balance_of(std::vector<double>{1, 4, 1, 2});
  EXPECT_EQ(balance.largest, 4);
  EXPECT_EQ(balance.mean, 2);
  EXPECT_EQ(balance.ratio(), 2);
  EXPECT_EQ(balance_of({}).ratio(), 1);
  EXPECT_EQ(balance_of(std::vector<double>{0, 0}).ratio(), 1);
  EXPECT_EQ(sums_of_groups(std::vector<double>{1, 2, 4, 8}, std::vector<std::int32_t>{1, 0, 1, 2}),
            (std::vector<double>{2, 5, 8}));
}

}  // namespace
}  // namespace tetfarm
