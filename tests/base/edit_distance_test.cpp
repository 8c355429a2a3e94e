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

TEST(NearestWord, may_be_two_letters_or_a_third_of_the_word_away) {
  constexpr std::array<std::string_view, 1> word = {"max_elements"};
  EXPECT_EQ(nearest_word("max_elem", word), "max_elements") << "four of twelve";
  EXPECT_EQ(nearest_word("max_ele", word), "") << "five of twelve";
  constexpr std::array<std::string_view, 1> brief = {"box"};
  EXPECT_EQ(nearest_word("b", brief), "box");
  EXPECT_EQ(nearest_word("", brief), "") << "all of its letters";
  constexpr std::array<std::string_view, 2> two = {"abcd", "abcdef"};
  EXPECT_EQ(nearest_word("abcde", two), "abcd");
  EXPECT_EQ(nearest_word("abcdex", two), "abcdef") << "the nearer one, though it comes later";
  EXPECT_EQ(nearest_word("abcd", {}), "");
  const std::string longest(64, 'x');
  const std::array<std::string_view, 1> same = {longest};
  EXPECT_EQ(nearest_word(longest, same), longest);
  EXPECT_EQ(nearest_word(longest + "x", same), "");
}

TEST(EditDistance, is_the_same_both_ways_and_counts_a_swap_as_one) {
  EXPECT_EQ(edit_distance("ab", "ba"), 1U);
  EXPECT_EQ(edit_distance("abc", ""), 3U);
  EXPECT_EQ(edit_distance("ca", "abc"), 3U) << "what was swapped is not edited again";
  EXPECT_EQ(edit_distance("abc", "ca"), 3U);
  EXPECT_EQ(edit_distance("", ""), 0U);
  EXPECT_EQ(edit_distance("abab", "baba"), 2U);
}

}  // namespace
}  // namespace tetfarm
