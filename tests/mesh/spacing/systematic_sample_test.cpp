#include "mesh/spacing/systematic_sample.h"

#include <gtest/gtest.h>

#include <set>

namespace tetfarm {
namespace {

TEST(SystematicSample, takes_all_that_are_not_too_many) {
  const SystematicSample choice = systematic_sample(5, 6);
  EXPECT_EQ(choice.stride, 1);
  EXPECT_EQ(choice.numbers, (std::vector<std::size_t>{0, 1, 2, 3, 4}));
  EXPECT_TRUE(systematic_sample(0, 5).numbers.empty());
}

TEST(SystematicSample, takes_one_of_each_stride) {
  for (const std::size_t count : {1, 7, 8, 9, 1000, 4097, 123457}) {
    for (const std::size_t most : {0, 1, 2, 3, 64, 1000}) {
      const SystematicSample choice = systematic_sample(count, most);
      EXPECT_LE(choice.numbers.size(), most + 2);
      // The last stride may hold nothing: its number may lie beyond the end.
      EXPECT_GE((choice.numbers.size() + 1) * choice.stride, count);
      for (std::size_t i = 0; i < choice.numbers.size(); ++i) {
        EXPECT_EQ(choice.numbers[i] / choice.stride, i);
        EXPECT_LT(choice.numbers[i], count);
      }
    }
  }
}

TEST(SystematicSample, lies_anywhere_in_a_stride) {
  const SystematicSample choice = systematic_sample(100000, 4000);
  std::set<std::size_t> places;
  for (const std::size_t number : choice.numbers) places.insert(number % choice.stride);
  EXPECT_EQ(places.size(), choice.stride);
}

}  // namespace
}  // namespace tetfarm
