#include "mesh/render/axis_ticks.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

namespace tetfarm {
namespace {

using ::testing::ElementsAre;

std::vector<std::string> texts(double low, double high, int most) {
  std::vector<std::string> texts;
  for (const AxisTick& tick : axis_ticks(low, high, most)) texts.push_back(tick.text);
  return texts;
}

TEST(AxisTicks, are_round_numbers_within_the_range) {
  EXPECT_THAT(texts(0, 1, 6), ElementsAre("0", "0.2", "0.4", "0.6", "0.8", "1.0"));
  EXPECT_THAT(texts(-0.55, 0.55, 5), ElementsAre("-0.4", "-0.2", "0", "0.2", "0.4"));
  EXPECT_THAT(texts(101320, 101341, 3), ElementsAre("101320", "101330", "101340"));
  EXPECT_THAT(texts(-7, 113, 4), ElementsAre("0", "50", "100"));
}

TEST(AxisTicks, are_written_with_powers_of_ten_where_they_are_large_or_small) {
  EXPECT_THAT(texts(0, 2.1e-7, 3), ElementsAre("0", "1e-7", "2e-7"));
  EXPECT_THAT(texts(1e7, 1.26e7, 3), ElementsAre("1e7", "1.1e7", "1.2e7"));
  EXPECT_THAT(texts(-2e20, 2e20, 5), ElementsAre("-2e20", "-1e20", "0", "1e20", "2e20"));
}

TEST(AxisTicks, are_at_most_as_many_as_asked_for_and_written_exactly) {
  for (int i = 0; i < 200; ++i) {
    const double low = 100 * std::sin(i);
    const double high = low + std::exp(0.2 * i - 20);
    for (const int most : {1, 2, 5, 11}) {
      const std::vector<AxisTick> ticks = axis_ticks(low, high, most);
      EXPECT_LE(ticks.size(), static_cast<std::size_t>(most));
      if (high - low < 1e-9) continue;
      EXPECT_GE(static_cast<int>(ticks.size()), most / 3);
      for (const AxisTick& tick : ticks) {
        EXPECT_EQ(std::strtod(tick.text.c_str(), nullptr), tick.value);
        EXPECT_GT(tick.value, low - 1e-6 * (high - low));
        EXPECT_LT(tick.value, high + 1e-6 * (high - low));
      }
    }
  }
}

TEST(AxisTicks, are_one_where_numbers_cannot_be_told_apart) {
  EXPECT_THAT(texts(3, 3, 5), ElementsAre("3"));
  EXPECT_THAT(texts(0, 0, 5), ElementsAre("0"));
  EXPECT_EQ(axis_ticks(1e6, 1e6 + 1e-9, 5).size(), 1U);
}

}  // namespace
}  // namespace tetfarm
