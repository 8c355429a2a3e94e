#include "mesh/decompose/decomposition_plan.h"

#include <gmock/gmock.h>

#include "mesh/decompose/planar_cut.h"
#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

using ::testing::SizeIs;

std::int64_t as_told(double, double, std::int64_t parts) { return parts; }

std::vector<PlannedSubdomain> leaves_of(const std::vector<PlannedSubdomain>& tree) {
  std::vector<PlannedSubdomain> leaves;
  for (const PlannedSubdomain& node : tree) {
    if (node.parts == 1) leaves.push_back(node);
  }
  return leaves;
}

class Planned : public ::testing::Test {
 protected:
  Subdomain root_ = root_subdomain(shapes::box({0, 0, 0}, {2, 1, 1}, 8));
  SpacingField spacing_{0.1};
  double elements_ = estimated_elements(root_, spacing_);
};

TEST_F(Planned, one_part_is_the_root) {
  const auto tree = plan_decomposition(root_, spacing_, 1, as_told);
  ASSERT_THAT(tree, SizeIs(1));
  EXPECT_NEAR(tree[0].elements, elements_, 1e-6 * elements_);
  EXPECT_EQ(tree[0].triangles, static_cast<double>(root_.triangles.size()));
}

TEST_F(Planned, there_are_as_many_even_leaves_as_wanted) {
  const auto tree = plan_decomposition(root_, spacing_, 6, as_told);
  EXPECT_THAT(tree, SizeIs(11));
  const auto leaves = leaves_of(tree);
  ASSERT_THAT(leaves, SizeIs(6));
  double sum = 0;
  for (const PlannedSubdomain& leaf : leaves) {
    sum += leaf.elements;
    EXPECT_NEAR(leaf.elements, elements_ / 6, 0.12 * elements_ / 6);
  }
  EXPECT_NEAR(sum, elements_, 1e-6 * elements_);
  for (std::size_t i = 1; i < tree.size(); ++i) {
    EXPECT_TRUE(tree[i].path.heap / 2 == tree[i - 1].path.heap || tree[i - 1].parts == 1)
        << "depth first";
  }
}

TEST_F(Planned, the_first_cut_is_across_and_has_the_triangles_of_its_area) {
  const auto tree = plan_decomposition(root_, spacing_, 2, as_told);
  ASSERT_THAT(tree, SizeIs(3));
  const double of_cut =
      0.5 * (tree[1].triangles + tree[2].triangles - static_cast<double>(root_.triangles.size()));
  EXPECT_NEAR(of_cut, 231, 25) << "1 x 1 at a spacing of 0.1";
}

TEST_F(Planned, a_limit_decides_where_to_stop) {
  const double most = elements_ / 5;
  const auto by_size = [most](double elements, double, std::int64_t) {
    return elements <= most ? std::int64_t{1} : static_cast<std::int64_t>(elements / most) + 1;
  };
  const auto leaves = leaves_of(plan_decomposition(root_, spacing_, 6, by_size));
  EXPECT_GE(leaves.size(), 5U);
  for (const PlannedSubdomain& leaf : leaves) EXPECT_LE(leaf.elements, most);
}

TEST_F(Planned, is_near_to_what_real_cuts_make) {
  const CutOutcome outcome = planar_cut(root_, spacing_);
  ASSERT_TRUE(outcome.cut);
  const auto tree = plan_decomposition(root_, spacing_, 2, as_told);
  const auto real = static_cast<double>(outcome.cut->left.triangles.size());
  EXPECT_NEAR(tree[1].triangles, real, 0.1 * real);
  EXPECT_NEAR(tree[1].elements, estimated_elements(outcome.cut->left, spacing_), 0.02 * elements_);
}

}  // namespace
}  // namespace tetfarm
