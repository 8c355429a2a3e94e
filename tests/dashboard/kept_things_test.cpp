#include "dashboard/kept_things.h"

#include <gtest/gtest.h>

namespace tetfarm {
namespace {

KeptThings<int>::Kept thing(const std::string& name, FetchTime fetched, std::size_t size = 1) {
  return {name, fetched, size, std::make_shared<const int>(1)};
}

TEST(KeptThings, are_fresh_for_two_seconds_and_for_ten_times_what_fetching_took) {
  EXPECT_TRUE(is_fresh({1'000, 0}, 2'999));
  EXPECT_FALSE(is_fresh({1'000, 0}, 3'000));
  EXPECT_TRUE(is_fresh({1'000, 5'000}, 50'999));
  EXPECT_FALSE(is_fresh({1'000, 5'000}, 51'000));
}

TEST(KeptThings, are_found_by_name_until_they_are_old) {
  KeptThings<int> kept(4, 100);
  kept.keep(thing("a", {0, 0}));
  EXPECT_NE(kept.find("a", 1'000), nullptr);
  EXPECT_EQ(kept.find("b", 1'000), nullptr);
  EXPECT_EQ(kept.find("a", 2'000), nullptr);
}

TEST(KeptThings, of_too_many_lose_the_one_that_was_used_longest_ago) {
  KeptThings<int> kept(2, 100);
  kept.keep(thing("a", {0, 0}));
  kept.keep(thing("b", {0, 0}));
  kept.find("a", 0);
  kept.keep(thing("c", {0, 0}));
  EXPECT_NE(kept.find("a", 0), nullptr);
  EXPECT_EQ(kept.find("b", 0), nullptr);
  EXPECT_EQ(kept.count(), 2U);
}

TEST(KeptThings, are_bounded_by_their_sizes_together_and_alone) {
  KeptThings<int> kept(10, 100);
  kept.keep(thing("a", {0, 0}, 60));
  kept.keep(thing("b", {0, 0}, 60));
  EXPECT_EQ(kept.find("a", 0), nullptr);
  EXPECT_NE(kept.find("b", 0), nullptr);
  kept.keep(thing("giant", {0, 0}, 101));
  EXPECT_EQ(kept.find("giant", 0), nullptr);
  EXPECT_NE(kept.find("b", 0), nullptr);
}

TEST(KeptThings, replace_what_has_the_same_name) {
  KeptThings<int> kept(10, 100);
  kept.keep(thing("a", {0, 0}, 60));
  kept.keep(thing("a", {5'000, 0}, 60));
  EXPECT_EQ(kept.count(), 1U);
  EXPECT_NE(kept.find("a", 6'000), nullptr);
}

}  // namespace
}  // namespace tetfarm
