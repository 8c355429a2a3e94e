#include "mesh/core/signed_volume.h"

#include <gtest/gtest.h>

namespace tetfarm {
namespace {

TEST(SignedVolume, is_positive_where_the_fourth_node_lies_above_the_others) {
  EXPECT_EQ(6 * signed_volume({0, 0, 0}, {2, 0, 0}, {0, 3, 0}, {0, 0, 4}), 24);
  EXPECT_EQ(6 * signed_volume({0, 0, 0}, {0, 3, 0}, {2, 0, 0}, {0, 0, 4}), -24);
  EXPECT_EQ(signed_volume({0, 0, 0}, {0, 3, 0}, {2, 0, 0}, {7, 8, 0}), 0);
}

TEST(HasPositiveVolume, tells_a_tet_as_flat_as_doubles_can_make_it_from_one_that_is_flat) {
  // Six times the volume is e^2, the difference of 1 and (1 + e)(1 - e).
  constexpr double e = 0x1p-52;
  const Vec3 a{0, 0, 0}, b{1, 0, 0}, c{0, 1, 1 - e}, d{0, 1 + e, 1};
  EXPECT_EQ(signed_volume(a, b, c, d), 0) << "long double cannot tell";
  EXPECT_TRUE(has_positive_volume(a, b, c, d));
  EXPECT_FALSE(has_positive_volume(a, b, d, c)) << "it is turned";
  EXPECT_FALSE(has_positive_volume(a, b, c, c));
}

}  // namespace
}  // namespace tetfarm
