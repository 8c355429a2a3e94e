#include "mesh/geometry/fine_point.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "mesh/geometry/predicates.h"

namespace tetfarm {
namespace {

int sign(double x) { return (x > 0) - (x < 0); }

class FinePoints : public testing::Test {
 protected:
  std::mt19937_64 random_{11};
  double number() { return std::uniform_real_distribution<double>(-1, 1)(random_); }
  Vec3 place() { return {number(), number(), number()}; }
};

TEST_F(FinePoints, orient3d_is_that_of_doubles_for_plain_points) {
  for (int i = 0; i < 2000; ++i) {
    const Vec3 a = place(), b = place(), c = place();
    // Every other one lies in the plane up to rounding.
    const Vec3 d = i % 2 == 0 ? place() : a + 0.3 * (b - a) + 0.2 * (c - a);
    ASSERT_EQ(sign(orient3d(fine(a), fine(b), fine(c), fine(d))), sign(orient3d(a, b, c, d)));
  }
}

TEST_F(FinePoints, orient3d_tells_the_sides_of_a_plane_far_below_the_last_digit_of_doubles) {
  for (int i = 0; i < 2000; ++i) {
    const auto real = [this] { return number(); };
    const double height = std::ldexp(1.0, -60 - i % 40);
    const auto on_plane = [&](double low) { return FinePoint{{real(), real(), 0.1}, {0, 0, low}}; };
    const FinePoint a = on_plane(height), b = on_plane(height), c = on_plane(height);
    const FinePoint above = on_plane(std::nextafter(height, 1)), in = on_plane(height);
    const int turn = sign(orient2d_along(2, a, b, c));
    ASSERT_NE(turn, 0);
    ASSERT_EQ(sign(orient3d(a, b, c, above)), turn);
    ASSERT_EQ(sign(orient3d(b, a, c, above)), -turn);
    ASSERT_EQ(sign(orient3d(c, a, b, above)), turn);
    ASSERT_EQ(sign(orient3d(above, b, c, a)), -turn);
    ASSERT_EQ(orient3d(a, b, c, in), 0);
  }
}

TEST_F(FinePoints, between_two_points_lie_on_their_line_to_a_hundred_bits) {
  for (int i = 0; i < 500; ++i) {
    const FinePoint a = fine(place()), b = fine(place());
    const DoubleDouble share = DoubleDouble{1, 0} / DoubleDouble{3 + std::abs(number()), 1e-18};
    const FinePoint p = between(a, b, share);
    EXPECT_LT(norm(cross(difference(a, b), difference(a, p)).rounded()), 1e-29);
    EXPECT_NEAR(norm(p.high - a.high), share.high * norm(b.high - a.high), 1e-15);
  }
}

TEST(DoubleDouble, a_quotient_times_its_divisor_is_the_dividend_to_a_hundred_bits) {
  for (int i = 1; i < 1000; ++i) {
    const DoubleDouble a = {1.0 / i, 1e-18 / i}, b = {std::sqrt(i + 0.5), -1e-17};
    const DoubleDouble rest = (a / b) * b - a;
    EXPECT_LT(std::abs(rest.high), 1e-30 / i);
  }
}

}  // namespace
}  // namespace tetfarm
