#include "base/angle_text.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

namespace tetfarm {
namespace {

TEST(AngleText, has_two_decimals_where_these_tell_enough) {
  EXPECT_EQ(angle_text(24.3127), "24.31");
  EXPECT_EQ(angle_text(1.004), "1.00");
  EXPECT_EQ(angle_text(150.5), "150.50");
}

TEST(AngleText, has_as_many_decimals_as_are_asked_for_at_least) {
  EXPECT_EQ(angle_text(12.345, 3), "12.345");
  EXPECT_EQ(angle_text(0.5, 3), "0.500");
  EXPECT_EQ(angle_text(0.00213, 3), "0.0021");
}

TEST(AngleText, tells_a_small_angle_from_none) {
  EXPECT_EQ(angle_text(0.4), "0.40");
  EXPECT_EQ(angle_text(0.0213), "0.021");
  EXPECT_EQ(angle_text(0.00213), "0.0021");
  EXPECT_EQ(angle_text(0.00022), "0.00022");
}

TEST(AngleText, tells_an_angle_near_180_from_180) {
  EXPECT_EQ(angle_text(179.995), "179.9950");
  EXPECT_EQ(angle_text(179.75), "179.75");
}

TEST(AngleText, is_flat_only_for_what_is_flat) {
  EXPECT_EQ(angle_text(0), "0");
  EXPECT_EQ(angle_text(180), "180");
  for (double deg = 1; deg > 2e-8; deg /= 3) {
    EXPECT_GT(std::stod(angle_text(deg)), 0) << deg;
    EXPECT_LT(std::stod(angle_text(180 - deg)), 180) << deg;
  }
}

TEST(AngleText, of_what_is_no_such_angle_is_plain) {
  EXPECT_EQ(angle_text(-5), "-5.00");
  EXPECT_EQ(angle_text(200), "200.00");
}

TEST(AngleText, has_two_digits_of_what_an_angle_differs_by_from_0_or_180) {
  EXPECT_EQ(angle_text(0.999), "1.00");
  EXPECT_EQ(angle_text(0.1), "0.100");
  EXPECT_EQ(angle_text(0.011), "0.011");
  EXPECT_EQ(angle_text(0.0099), "0.0099");
  EXPECT_EQ(angle_text(1e-9), "0.000000001");
  EXPECT_EQ(angle_text(179.0), "179.00");
  EXPECT_EQ(angle_text(179.5, 1), "179.50");
  EXPECT_EQ(angle_text(30, 0), "30");
  EXPECT_EQ(angle_text(30, 9), "30.000000000");
  EXPECT_EQ(angle_text(0, 5), "0");
  EXPECT_EQ(angle_text(180, 5), "180");
}

}  // namespace
}  // namespace tetfarm
