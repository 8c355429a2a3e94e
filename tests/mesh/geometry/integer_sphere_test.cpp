#include "mesh/geometry/integer_sphere.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

#include "mesh/geometry/expansion.h"
#include "mesh/geometry/predicates.h"

namespace tetfarm {
namespace {

int sign(double x) { return (x > 0) - (x < 0); }

/// By expansions alone.
int sphere_sign_by_expansions(const std::array<Vec3, 5>& p) {
  using Number = Expansion<4096>;
  const auto number = [](const auto& e) {
    Number n;
    for (std::size_t i = 0; i < e.length; ++i) n.append(e.component[i]);
    return n;
  };
  std::array<std::array<Expansion<2>, 3>, 4> v;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto axis = static_cast<int>(k);
      v[i][k] = exact_difference(p[i][axis], p[4][axis]);
    }
  }
  const auto minor = [&v](std::size_t i, std::size_t j, std::size_t k) {
    const auto pair = [&](std::size_t x, std::size_t y) {
      return v[i][x] * v[j][y] - v[i][y] * v[j][x];
    };
    return pair(1, 2) * v[k][0] + pair(2, 0) * v[k][1] + pair(0, 1) * v[k][2];
  };
  const auto lift = [&v](std::size_t i) {
    return v[i][0] * v[i][0] + v[i][1] * v[i][1] + v[i][2] * v[i][2];
  };
  const auto sum = (minor(1, 2, 3) * lift(0) - minor(0, 2, 3) * lift(1)) +
                   (minor(0, 1, 3) * lift(2) - minor(0, 1, 2) * lift(3));
  return sign(number(sum).most_significant());
}

TEST(IntegerSphere, agrees_with_expansions_whatever_its_numbers_take) {
  // Places on one sphere, single bits off it, and any, with coordinates of 6 to 59 bits.
  std::mt19937_64 random(7);
  std::array<int, 3> found{};
  for (int i = 0; i < 20000; ++i) {
    const int bits = 6 + i % 52;
    const auto whole = [&] {
      return std::uniform_int_distribution<std::int64_t>(1, (std::int64_t{1} << bits) - 1)(random);
    };
    // Doubles hold 53 bits; the small coordinate has the last of 60.
    const auto rounded = [](std::int64_t x) { return std::ldexp(static_cast<double>(x), -60); };
    const double x = rounded(whole()), y = rounded(whole()), z = rounded(whole() % 64 + 1);
    std::array<Vec3, 5> p = {
        {{x, y, z}, {y, x, -z}, {-x, y, -z}, {-y, -x, z}, {-x, -y, i % 2 == 0 ? z : -z}}};
    if (i % 3 == 1) p[4].z += rounded(1);
    for (Vec3& q : p) {
      if (i % 3 == 2) q = {rounded(whole()), rounded(whole()), rounded(whole())};
    }
    const auto side = integer_insphere(p[0], p[1], p[2], p[3], p[4]);
    ASSERT_TRUE(side.has_value());
    ASSERT_EQ(*side, sphere_sign_by_expansions(p)) << i;
    ++found[static_cast<std::size_t>(*side + 1)];
  }
  for (const int count : found) EXPECT_GT(count, 2000);
}

TEST(IntegerSphere, does_not_tell_what_takes_more_than_59_bits) {
  const double small = std::ldexp(1.0, -59);
  const Vec3 a{0, 0, 0}, b{1, 0, 0}, c{0, 1, 0}, d{0, 0, 1};
  EXPECT_EQ(integer_insphere(a, b, c, d, {small, small, small}), 1);
  EXPECT_EQ(integer_insphere(a, b, c, d, {small / 2, small, small}), std::nullopt);
  EXPECT_GT(insphere(a, b, c, d, {small / 2, small, small}), 0);
}

TEST(IntegerSphere, keeps_or_turns_its_sign_as_the_order_of_the_points_does) {
  std::mt19937_64 random(3);
  const auto whole = [&random] { return static_cast<double>(random() % 9) - 4; };
  std::array<int, 3> found{};
  for (int i = 0; i < 2000; ++i) {
    std::array<Vec3, 5> p;
    for (Vec3& q : p) q = {whole(), whole(), whole()};
    const int side = *integer_insphere(p[0], p[1], p[2], p[3], p[4]);
    ++found[static_cast<std::size_t>(side + 1)];
    EXPECT_EQ(integer_insphere(p[1], p[2], p[0], p[3], p[4]), side);
    EXPECT_EQ(integer_insphere(p[1], p[0], p[2], p[3], p[4]), -side);
    EXPECT_EQ(integer_insphere(p[0], p[1], p[2], p[4], p[3]), -side);
    const Vec3 far{1 << 20, -3 << 20, 7};
    EXPECT_EQ(integer_insphere(p[0] + far, p[1] + far, p[2] + far, p[3] + far, p[4] + far), side);
  }
  for (const int count : found) EXPECT_GT(count, 20);
}

TEST(IntegerSphere, does_not_tell_of_numbers_that_are_none) {
  const Vec3 a{0, 0, 0}, b{1, 0, 0}, c{0, 1, 0}, d{0, 0, 1};
  EXPECT_EQ(integer_insphere(a, b, c, d, {std::ldexp(1.0, 300), 0, 0}), std::nullopt);
  EXPECT_EQ(integer_insphere(a, a, a, a, a), 0);
}

/// The sign for a flat corner of that height over a plane of lengths 2^-power.
std::optional<int> sign_of_corner(int power) {
  const double small = std::ldexp(1.0, -power);
  return integer_insphere({1 + 0x1p-40, 0, 0}, {1, small, 0}, {1, 0, small}, {1, 0, 0},
                          {1, small, small});
}

TEST(IntegerSphere, takes_coordinates_of_62_bits_and_no_more) {
  EXPECT_TRUE(sign_of_corner(60).has_value());
  EXPECT_TRUE(sign_of_corner(61).has_value());
  EXPECT_FALSE(sign_of_corner(62).has_value());
  EXPECT_FALSE(sign_of_corner(63).has_value());
}

TEST(IntegerSphere, takes_differences_of_59_bits_and_no_more) {
  const auto sign_of = [](double x) {
    return integer_insphere({x, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}, {0, 1, 1});
  };
  EXPECT_TRUE(sign_of(0x1p58).has_value());
  EXPECT_FALSE(sign_of(0x1p59).has_value());
}

}  // namespace
}  // namespace tetfarm
