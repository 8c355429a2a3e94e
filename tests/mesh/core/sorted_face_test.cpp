#include "mesh/core/sorted_face.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace tetfarm {
namespace {

TEST(SortedFace, is_turned_by_an_odd_permutation_only) {
  const std::array<int, 3> ascending = {4, 7, 9};
  for (std::size_t start = 0; start < 3; ++start) {
    std::array<int, 3> here = ascending;
    std::rotate(here.begin(), here.begin() + static_cast<std::ptrdiff_t>(start), here.end());
    std::array<int, 3> turned = {here[1], here[0], here[2]};
    EXPECT_FALSE(sort_face(here));
    EXPECT_TRUE(sort_face(turned));
    EXPECT_EQ(here, ascending);
    EXPECT_EQ(turned, ascending);
  }
}

TEST(SortedFace, of_a_tet_is_the_same_from_both_of_its_sides) {
  const Tet tet = {8, 3, 5, 1};
  const Tet beyond = {3, 8, 5, 2};
  EXPECT_EQ(sorted_face(tet, 0), (std::array{1, 3, 5}));
  EXPECT_EQ(sorted_face(tet, 3), (std::array{3, 5, 8}));
  EXPECT_EQ(sorted_face(tet, 3), sorted_face(beyond, 3));
}

}  // namespace
}  // namespace tetfarm
