#include "base/edit_distance.h"

#include <gtest/gtest.h>

#include <array>

namespace tetfarm {
namespace {

TEST(EditDistance, counts_insertions_deletions_replacements_and_swaps) {
  EXPECT_EQ(edit_distance("growth", "growth"), 0U);
  EXPECT_EQ(edit_distance("grwth", "growth"), 1U);
  EXPECT_EQ(edit_distance("groowth", "growth"), 1U);
  EXPECT_EQ(edit_distance("grpwth", "growth"), 1U);
  EXPECT_EQ(edit_distance("grwoth", "growth"), 1U);
  EXPECT_EQ(edit_distance("", "abc"), 3U);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3U);
}

TEST(NearestWord, finds_a_typing_error_and_leaves_other_words_alone) {
  constexpr std::array<std::string_view, 3> words = {"growth", "default", "at"};
  EXPECT_EQ(nearest_word("grow", words), "growth");
  EXPECT_EQ(nearest_word("defualt", words), "default");
  EXPECT_EQ(nearest_word("colour", words), "");
  EXPECT_EQ(nearest_word("xy", words), "");
  EXPECT_EQ(nearest_word(std::string(100000, 'x'), words), "");
}

TEST(NearestWord, is_the_first_of_those_that_are_equally_near) {
  constexpr std::array<std::string_view, 3> words = {"surface", "mesh", "mess"};
  EXPECT_EQ(nearest_word("mest", words), "mesh");
}

}  // namespace
}  // namespace tetfarm
