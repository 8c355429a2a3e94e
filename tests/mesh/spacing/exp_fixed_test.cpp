#include "mesh/spacing/exp_fixed.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tetfarm {
namespace {

TEST(ExpFixed, agrees_with_libm) {
  for (double x = -690; x < 690; x += 0.37) {
    EXPECT_NEAR(exp_fixed(x) / std::exp(x), 1, 1e-15) << x;
  }
  EXPECT_EQ(exp_fixed(0), 1);
}

TEST(ExpFixed, saturates) {
  EXPECT_EQ(exp_fixed(-1e9), 0);
  EXPECT_TRUE(std::isinf(exp_fixed(1e9)));
}

TEST(LogFixed, agrees_with_libm) {
  for (double x = 1e-300; x < 1e300; x *= 1.83) {
    EXPECT_NEAR(log_fixed(x), std::log(x), 1e-15 * (1 + std::abs(std::log(x)))) << x;
  }
  EXPECT_EQ(log_fixed(1), 0);
}

TEST(LogFixed, inverts_exp) {
  for (double x = -5; x < 5; x += 0.01) EXPECT_NEAR(log_fixed(exp_fixed(x)), x, 1e-14);
}

}  // namespace
}  // namespace tetfarm
