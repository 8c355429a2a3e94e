#include "mesh/cosmetics/element_collapse.h"

#include <gmock/gmock.h>

#include "tests/mesh/cosmetics/trial_meshes.h"

namespace tetfarm::cosmetics {
namespace {

using testing::IsEmpty;
using trial::box_with_inner_node;

TEST(ElementCollapse, removes_a_node_that_lies_close_to_another) {
  TetComplex complex = box_with_inner_node({1.97, 1, 1});
  ASSERT_THAT(validate(complex), IsEmpty());
  WorkMesh work(complex, 26);
  std::int32_t near = -1;
  for (std::int32_t v = 0; v < 26; ++v) {
    if (work.point(v) == Vec3{2, 1, 1}) near = v;
  }
  const std::vector<std::int32_t> ball = ball_of_node(work, 26);
  const auto found = find_collapse(work, ball, 26, near, 0);
  ASSERT_TRUE(found.has_value());
  EXPECT_LT(found->new_tets.size(), found->old_tets.size());
  EXPECT_FALSE(replace_tets(work, *found).empty());
  EXPECT_THAT(validate(complex), IsEmpty());
  EXPECT_EQ(complex.node2tet[26], -1);
}

TEST(ElementCollapse, is_nothing_when_it_makes_flat_tets) {
  TetComplex complex = box_with_inner_node({1, 1, 1});
  WorkMesh work(complex, 26);
  const std::vector<std::int32_t> ball = ball_of_node(work, 26);
  for (std::int32_t onto = 0; onto < 26; ++onto) {
    EXPECT_FALSE(find_collapse(work, ball, 26, onto, 0).has_value());
  }
}

}  // namespace
}  // namespace tetfarm::cosmetics
