#include "mesh/assimilation/assimilation.h"

#include <gmock/gmock.h>

#include <random>
#include <set>

#include "base/error.h"
#include "mesh/assimilation/group_refinement.h"
#include "mesh/decompose/planar_cut.h"
#include "tests/mesh/assimilation/leaf_graphs.h"
#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

double volume(const Subdomain& s) { return enclosed_volume(s.vertices, s.triangles); }

void cut_into(const Subdomain& subdomain, const SpacingField& spacing, int parts,
              std::vector<Subdomain>& leaves) {
  const CutOutcome outcome = parts > 1 ? planar_cut(subdomain, spacing) : CutOutcome{};
  if (!outcome.cut) {
    leaves.push_back(subdomain);
    return;
  }
  cut_into(outcome.cut->left, spacing, parts / 2, leaves);
  cut_into(outcome.cut->right, spacing, parts - parts / 2, leaves);
}

SubdomainGraph graph_of(const std::vector<Subdomain>& leaves) {
  SubdomainGraphBuilder builder;
  for (const Subdomain& leaf : leaves) builder.add(leaf, volume(leaf));
  return std::move(builder).finish();
}

/// A torus in sixteen leaves, cut once for all tests.
class Torus : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    root_ = new Subdomain(root_subdomain(shapes::torus(0.4, 48, 20)));
    leaves_ = new std::vector<Subdomain>;
    cut_into(*root_, SpacingField(0.11), 16, *leaves_);
  }
  static void TearDownTestSuite() {
    delete root_;
    delete leaves_;
  }

  static Subdomain* root_;
  static std::vector<Subdomain>* leaves_;
};

Subdomain* Torus::root_ = nullptr;
std::vector<Subdomain>* Torus::leaves_ = nullptr;

TEST_F(Torus, all_leaves_joined_are_the_root) {
  const Subdomain joined = join_subdomains(*leaves_);
  EXPECT_THAT(validate(joined), IsEmpty());
  EXPECT_EQ(joined.vertices.size(), root_->vertices.size());
  EXPECT_EQ(joined.triangles.size(), root_->triangles.size());
  for (const Origin& origin : joined.triangle_origin) EXPECT_EQ(origin.owner, 0U);
  EXPECT_NEAR(volume(joined), volume(*root_), 1e-12);
}

TEST_F(Torus, one_leaf_joined_is_itself) {
  const Subdomain& leaf = leaves_->at(3);
  const Subdomain joined = join_subdomains({&leaf, 1});
  EXPECT_EQ(joined.path, leaf.path);
  EXPECT_EQ(joined.vertices, leaf.vertices);
  EXPECT_EQ(joined.triangles, leaf.triangles);
  EXPECT_EQ(joined.node_origin, leaf.node_origin);
}

TEST_F(Torus, the_graph_knows_who_shares_how_many_triangles) {
  ASSERT_EQ(leaves_->size(), 16U);
  const SubdomainGraph graph = graph_of(*leaves_);
  for (std::size_t a = 0; a < graph.size(); ++a) {
    std::set<Origin> here;
    for (const Origin& origin : leaves_->at(a).triangle_origin) here.insert(origin);
    std::vector<Neighbour> expected;
    for (std::size_t b = 0; b < graph.size(); ++b) {
      std::int32_t shared = 0;
      for (const Origin& origin : leaves_->at(b).triangle_origin) {
        shared += a != b && here.contains(origin) ? 1 : 0;
      }
      if (shared > 0) expected.push_back({static_cast<std::int32_t>(b), shared});
    }
    ASSERT_EQ(graph.neighbours[a].size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
      EXPECT_EQ(graph.neighbours[a][i].leaf, expected[i].leaf);
      EXPECT_EQ(graph.neighbours[a][i].triangles, expected[i].triangles);
    }
    EXPECT_EQ(graph.faces[a], std::ssize(leaves_->at(a).triangles));
  }
}

TEST_F(Torus, a_missing_leaf_and_one_that_comes_twice_are_noticed) {
  std::vector<Subdomain> some(leaves_->begin(), leaves_->end() - 1);
  EXPECT_THROW(graph_of(some), Error);
  some = *leaves_;
  some.push_back(some.front());
  EXPECT_THROW(graph_of(some), Error);
}

TEST_F(Torus, leaves_that_do_not_fit_are_not_joined) {
  std::vector<Subdomain> two(leaves_->begin(), leaves_->begin() + 2);
  two[1].vertices[0].x += 1e-9;
  for (std::size_t v = 0; v < two[1].vertices.size(); ++v) two[1].vertices[v].x += 1e-9;
  EXPECT_THROW(join_subdomains(two), Error);
  two[1] = leaves_->at(1);
  for (Triangle& triangle : two[1].triangles) std::swap(triangle[0], triangle[1]);
  EXPECT_THROW(join_subdomains(two), Error);
  two[1] = two[0];
  for (Triangle& triangle : two[1].triangles) std::swap(triangle[0], triangle[1]);
  EXPECT_THROW(join_subdomains(two), Error) << "a triangle of the surface is in one leaf only";
}

/// What holds for every way of grouping: the joined sub-domains are sound, fill the root, and
/// share each remaining cut triangle exactly twice.
void expect_sound_groups(const std::vector<Subdomain>& leaves,
                         const std::vector<std::int32_t>& leaf2group, double whole) {
  std::map<std::int32_t, std::vector<Subdomain>> members;
  for (std::size_t i = 0; i < leaves.size(); ++i) members[leaf2group[i]].push_back(leaves[i]);
  CutNodeMarks nodes;
  for (const Subdomain& leaf : leaves) nodes.add_leaf(leaf);
  std::vector<Subdomain> groups;
  double sum = 0;
  for (const auto& [group, parts] : members) {
    groups.push_back(join_subdomains(parts));
    nodes.add_joined(groups.back());
    EXPECT_THAT(validate(groups.back()), IsEmpty()) << "group " << group;
    EXPECT_EQ(groups.back().path, parts.front().path);
    sum += volume(groups.back());
  }
  EXPECT_NEAR(sum, whole, 1e-12 * whole);
  EXPECT_NO_THROW(graph_of(groups)) << "remaining triangles are shared by two groups";
  std::set<Origin> dropped;
  for (const auto& [cut, first, count] : nodes.dropped()) {
    for (std::uint32_t i = 0; i < count; ++i) dropped.insert({cut.heap, first + i});
  }
  std::set<Origin> kept;
  std::set<Origin> there;
  for (const Subdomain& leaf : leaves)
    there.insert(leaf.node_origin.begin(), leaf.node_origin.end());
  for (const Subdomain& group : groups)
    kept.insert(group.node_origin.begin(), group.node_origin.end());
  for (const Origin& node : there) EXPECT_NE(kept.contains(node), dropped.contains(node));
}

TEST_F(Torus, every_method_and_number_of_groups_gives_sound_subdomains) {
  const SubdomainGraph graph = graph_of(*leaves_);
  for (const PartitionMethod method :
       {PartitionMethod::recursive, PartitionMethod::k_way, PartitionMethod::k_way_volume}) {
    for (const std::int32_t groups : {1, 2, 3, 5, 8, 16, 40}) {
      const std::vector<std::int32_t> leaf2group = assimilate(graph, groups, method);
      EXPECT_TRUE(groups_are_connected(graph, leaf2group));
      EXPECT_EQ(1 + *std::max_element(leaf2group.begin(), leaf2group.end()), std::min(groups, 16));
      expect_sound_groups(*leaves_, leaf2group, volume(*root_));
    }
  }
}

TEST_F(Torus, even_random_groups_that_touch_at_edges_only_join_soundly) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    std::mt19937_64 random(seed);
    std::vector<std::int32_t> leaf2group(leaves_->size());
    for (std::int32_t& group : leaf2group) group = static_cast<std::int32_t>(random() % 4);
    expect_sound_groups(*leaves_, leaf2group, volume(*root_));
  }
}

TEST(Assimilation, some_hundred_uneven_leaves_make_eight_even_groups) {
  SubdomainGraph graph = test::uneven_grid(5, 1.8, 5);
  for (const PartitionMethod method :
       {PartitionMethod::recursive, PartitionMethod::k_way, PartitionMethod::k_way_volume}) {
    const std::vector<std::int32_t> leaf2group = assimilate(graph, 8, method);
    EXPECT_LE(balance_of(sums_of_groups(graph.work, leaf2group)).ratio(), 1.05);
    EXPECT_TRUE(groups_are_connected(graph, leaf2group));
  }
}

TEST(Assimilation, pieces_of_the_domain_that_touch_nothing_stay_groups_of_their_own) {
  const SubdomainGraph apart = test::unconnected_leaves(3);
  EXPECT_THAT(assimilate(apart, 1, PartitionMethod::recursive), ElementsAre(0, 1, 2));
}

TEST(Assimilation, pieces_of_the_domain_get_groups_by_their_work) {
  SubdomainGraph graph = test::uneven_grid(4, 1.2, 3);
  const SubdomainGraph light = test::leaf_grid(2);
  const auto first = static_cast<std::int32_t>(graph.size());
  for (std::size_t leaf = 0; leaf < light.size(); ++leaf) {
    graph.path.push_back({1000 + leaf});
    graph.work.push_back(2700);
    graph.faces.push_back(60);
    graph.interface_nodes.push_back(20);
    graph.neighbours.push_back(light.neighbours[leaf]);
    for (Neighbour& other : graph.neighbours.back()) other.leaf += first;
  }
  const std::vector<std::int32_t> leaf2group = assimilate(graph, 8, PartitionMethod::recursive);
  EXPECT_TRUE(groups_are_connected(graph, leaf2group));
  const std::set<std::int32_t> of_first(leaf2group.begin(), leaf2group.begin() + first);
  const std::set<std::int32_t> of_second(leaf2group.begin() + first, leaf2group.end());
  EXPECT_EQ(of_first.size(), 6U) << "with three quarters of the work";
  EXPECT_THAT(of_second, ElementsAre(6, 7)) << "numbered by their first leaves";
  EXPECT_LE(balance_of(sums_of_groups(graph.work, leaf2group)).ratio(), 1.1);
}

TEST(Assimilation, balance_is_the_largest_over_the_mean) {
  const std::vector<double> amounts = {1, 2, 3};
  EXPECT_DOUBLE_EQ(balance_of(amounts).ratio(), 1.5);
  EXPECT_DOUBLE_EQ(balance_of({}).ratio(), 1);
}

}  // namespace
}  // namespace tetfarm
