#include "mesh/adaptation/round_numbers.h"

#include <gtest/gtest.h>

namespace tetfarm {
namespace {

TEST(RoundNumbers, are_the_decimal_numbers_themselves) {
  const auto steps = round_steps(0.7);
  EXPECT_EQ(rounded_to(0.30000001, steps[0]), 0.3);
  EXPECT_EQ(rounded_to(0.12345678, steps[3]), 0.123457);
  EXPECT_EQ(rounded_to(-0.70049, steps[0]), -0.7);
}

TEST(RoundNumbers, are_as_coarse_as_the_size_is_large) {
  EXPECT_EQ(rounded_to(20.0003, round_steps(20)[0]), 20);
  EXPECT_EQ(rounded_to(123456789.0, round_steps(2e8)[0]), 123e6);
  EXPECT_EQ(rounded_to(123456789.0, round_steps(2e8)[4]), 123456800);
}

TEST(RoundNumbers, are_as_good_within_two_and_a_half_times_the_distance) {
  EXPECT_TRUE(is_as_good(2e-5, 1e-5, 1));
  EXPECT_FALSE(is_as_good(3e-5, 1e-5, 1));
  EXPECT_TRUE(is_as_good(1e-13, 0, 1));
}

}  // namespace
}  // namespace tetfarm
