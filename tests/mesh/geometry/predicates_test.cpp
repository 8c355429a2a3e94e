#include "mesh/geometry/predicates.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "mesh/geometry/expansion.h"
#include "mesh/geometry/sphere_filter.h"

namespace tetfarm {
namespace {

__extension__ using Int = __int128;

int sign(double x) { return (x > 0) - (x < 0); }
int sign_of(Int x) { return (x > 0) - (x < 0); }

struct IntPoint {
  std::int64_t x, y, z;
  Vec3 real() const {
    return {static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)};
  }
  Vec2 flat() const { return {static_cast<double>(x), static_cast<double>(y)}; }
};

Int determinant(const IntPoint& a, const IntPoint& b, const IntPoint& c, const IntPoint& d) {
  const Int ux = b.x - a.x, uy = b.y - a.y, uz = b.z - a.z;
  const Int vx = c.x - a.x, vy = c.y - a.y, vz = c.z - a.z;
  const Int wx = d.x - a.x, wy = d.y - a.y, wz = d.z - a.z;
  return ux * (vy * wz - vz * wy) + uy * (vz * wx - vx * wz) + uz * (vx * wy - vy * wx);
}

/// Positive when e is inside the sphere of a positive tet.
Int lifted(const IntPoint& a, const IntPoint& b, const IntPoint& c, const IntPoint& d,
           const IntPoint& e) {
  const auto lift = [&e](const IntPoint& p) {
    const Int x = p.x - e.x, y = p.y - e.y, z = p.z - e.z;
    return x * x + y * y + z * z;
  };
  return lift(a) * determinant(e, b, c, d) - lift(b) * determinant(e, a, c, d) +
         lift(c) * determinant(e, a, b, d) - lift(d) * determinant(e, a, b, c);
}

class Predicates : public testing::Test {
 protected:
  std::mt19937_64 random_{7};
  IntPoint random_point(std::int64_t range) {
    std::uniform_int_distribution<std::int64_t> coordinate(-range, range);
    return {coordinate(random_), coordinate(random_), coordinate(random_)};
  }
};

TEST_F(Predicates, orient3d_agrees_with_integer_arithmetic_on_tiny_and_large_grids) {
  for (const std::int64_t range : {2LL, 9LL, 1000LL, 1LL << 30}) {
    for (int i = 0; i < 5000; ++i) {
      const IntPoint a = random_point(range), b = random_point(range), c = random_point(range),
                     d = random_point(range);
      ASSERT_EQ(sign(orient3d(a.real(), b.real(), c.real(), d.real())),
                sign_of(determinant(a, b, c, d)));
    }
  }
}

TEST_F(Predicates, orient3d_is_antisymmetric_for_points_one_ulp_off_a_plane) {
  for (int i = 0; i < 2000; ++i) {
    const auto real = [&] { return std::uniform_real_distribution<double>(0, 1)(random_); };
    const Vec3 a{real(), real(), 0.1}, b{real(), real(), 0.1}, c{real(), real(), 0.1};
    const Vec3 d{real(), real(), std::nextafter(0.1, 1)};
    ASSERT_NE(sign(orient3d(a, b, c, d)), 0);
    ASSERT_EQ(sign(orient3d(a, b, c, d)), -sign(orient3d(b, a, c, d)));
    ASSERT_EQ(sign(orient3d(a, b, c, d)), sign(orient3d(c, a, b, d)));
    ASSERT_EQ(sign(orient3d(a, b, c, d)), -sign(orient3d(d, b, c, a)));
  }
}

TEST_F(Predicates, orient3d_has_the_size_of_the_volume_where_rounding_leaves_nothing_of_it) {
  // N^2 - (N + 1)(N - 1) = 1, but the products round to the same double.
  const double n = 536870912.0;
  const double unit = std::ldexp(1.0, -40);
  const Vec3 a{0, 0, 0}, b{n * unit, (n + 1) * unit, 0}, c{(n - 1) * unit, n * unit, 0};
  const Vec3 d{0, 0, unit};
  EXPECT_EQ(orient3d(a, b, c, d), std::ldexp(1.0, -120));
  EXPECT_EQ(orient3d(a, c, b, d), -std::ldexp(1.0, -120));
}

TEST_F(Predicates, insphere_agrees_with_integer_arithmetic) {
  for (const std::int64_t range : {2LL, 5LL, 1000LL, 1LL << 20}) {
    for (int i = 0; i < 5000; ++i) {
      IntPoint a = random_point(range);
      IntPoint b = random_point(range);
      const IntPoint c = random_point(range), d = random_point(range), e = random_point(range);
      if (determinant(a, b, c, d) < 0) std::swap(a, b);
      if (determinant(a, b, c, d) == 0) continue;
      ASSERT_EQ(sign(insphere(a.real(), b.real(), c.real(), d.real(), e.real())),
                sign_of(lifted(a, b, c, d, e)));
    }
  }
}

TEST_F(Predicates, the_sphere_filter_is_never_certain_of_a_wrong_sign) {
  int undecided = 0;
  for (int i = 0; i < 5000; ++i) {
    const auto on_sphere = [&](double size) {
      const auto real = [&] { return std::uniform_real_distribution<double>(-1, 1)(random_); };
      return size * normalized(Vec3{real(), real(), real()}) + Vec3{0.1, 0.7, 0.3};
    };
    Vec3 a = on_sphere(1), b = on_sphere(1);
    const Vec3 c = on_sphere(1), d = on_sphere(1), e = on_sphere(1 + std::ldexp(1e-16, i % 16));
    if (orient3d(a, b, c, d) < 0) std::swap(a, b);
    const FilteredSphere filtered = filtered_insphere(a, b, c, d, e);
    if (filtered.is_certain) {
      ASSERT_EQ(filtered.det > 0, in_perturbed_sphere_exactly(a, b, c, d, e, {0, 1, 2, 3, 4}));
    } else {
      ++undecided;
    }
  }
  EXPECT_GT(undecided, 100);
  EXPECT_LT(undecided, 4900);
}

TEST_F(Predicates, insphere_keeps_its_sign_under_even_permutations_a_few_ulps_off_a_sphere) {
  for (int i = 0; i < 2000; ++i) {
    const auto on_sphere = [&](double size) {
      const auto real = [&] { return std::uniform_real_distribution<double>(-1, 1)(random_); };
      return size * normalized(Vec3{real(), real(), real()}) + Vec3{0.1, 0.7, 0.3};
    };
    const Vec3 a = on_sphere(1), b = on_sphere(1), c = on_sphere(1), d = on_sphere(1);
    const Vec3 e = on_sphere(1 + std::ldexp(1e-16, i % 8));
    const int side = sign(insphere(a, b, c, d, e));
    ASSERT_EQ(sign(insphere(b, c, a, d, e)), side);
    ASSERT_EQ(sign(insphere(b, a, c, d, e)), -side);
    ASSERT_EQ(sign(insphere(a, b, c, e, d)), -side);
    ASSERT_EQ(sign(insphere(e, b, c, d, a)), -side);
  }
}

TEST_F(Predicates, insphere_does_not_depend_on_a_scale_that_is_a_power_of_two) {
  for (int i = 0; i < 1000; ++i) {
    IntPoint a = random_point(3), b = random_point(3);
    const IntPoint c = random_point(3), d = random_point(3), e = random_point(3);
    if (determinant(a, b, c, d) < 0) std::swap(a, b);
    if (determinant(a, b, c, d) == 0) continue;
    for (const int power : {-190, -110, -90, -20, 20, 90, 110, 190}) {
      const double s = std::ldexp(1.0, power);
      ASSERT_EQ(
          sign(insphere(s * a.real(), s * b.real(), s * c.real(), s * d.real(), s * e.real())),
          sign_of(lifted(a, b, c, d, e)));
    }
  }
}

TEST_F(Predicates, insphere_of_grids_is_exact_up_to_the_largest_integers_and_beyond) {
  for (const std::int64_t half : {(1LL << 22) - 1, (1LL << 23) - 1, 1LL << 23, 1LL << 24}) {
    for (int i = 0; i < 500; ++i) {
      const auto corner = [&] {
        const auto either = [&] { return std::uniform_int_distribution(0, 1)(random_) * 2 - 1; };
        return IntPoint{half * either(), half * either(), half * either()};
      };
      IntPoint a = corner(), b = corner();
      const IntPoint c = corner(), d = corner(), e = corner();
      if (determinant(a, b, c, d) < 0) std::swap(a, b);
      if (determinant(a, b, c, d) == 0) continue;
      ASSERT_EQ(insphere(a.real(), b.real(), c.real(), d.real(), e.real()), 0);
    }
  }
}

TEST_F(Predicates, insphere_is_positive_inside_zero_on_and_negative_outside) {
  const Vec3 a{0, 0, 0}, b{1, 0, 0}, c{0, 1, 0}, d{0, 0, 1};
  ASSERT_GT(orient3d(a, b, c, d), 0);
  EXPECT_GT(insphere(a, b, c, d, {0.5, 0.5, 0.5}), 0);
  EXPECT_EQ(insphere(a, b, c, d, {1, 1, 1}), 0);
  EXPECT_LT(insphere(a, b, c, d, {3, 3, 3}), 0);
}

TEST_F(Predicates, perturbed_sphere_is_decided_alike_for_every_even_order_of_the_tet) {
  std::array<Vec3, 8> cube;
  for (std::size_t i = 0; i < 8; ++i) {
    cube[i] = {static_cast<double>(i & 1), static_cast<double>(i >> 1 & 1),
               static_cast<double>(i >> 2 & 1)};
  }
  std::array<std::int32_t, 8> number = {0, 1, 2, 3, 4, 5, 6, 7};
  for (int trial = 0; trial < 2000; ++trial) {
    std::shuffle(number.begin(), number.end(), random_);
    std::array<std::int32_t, 5> p{};
    std::copy_n(number.begin(), 5, p.begin());
    const auto at = [&](std::size_t i) { return cube[static_cast<std::size_t>(p[i])]; };
    const double volume = orient3d(at(0), at(1), at(2), at(3));
    if (volume == 0) continue;
    if (volume < 0) std::swap(p[0], p[1]);
    const auto inside = [&](std::size_t i, std::size_t j, std::size_t k, std::size_t l) {
      return in_perturbed_sphere(at(i), at(j), at(k), at(l), at(4), {p[i], p[j], p[k], p[l], p[4]});
    };
    const bool expected = inside(0, 1, 2, 3);
    ASSERT_EQ(inside(1, 2, 0, 3), expected);
    ASSERT_EQ(inside(1, 0, 3, 2), expected);
    ASSERT_EQ(inside(3, 2, 1, 0), expected);
  }
}

TEST_F(Predicates, orient2d_and_incircle_agree_with_integer_arithmetic) {
  const auto turn = [](const IntPoint& p, const IntPoint& q, const IntPoint& r) {
    return Int{p.x - r.x} * (q.y - r.y) - Int{p.y - r.y} * (q.x - r.x);
  };
  for (const std::int64_t range : {2LL, 9LL, 1LL << 24}) {
    for (int i = 0; i < 5000; ++i) {
      const IntPoint a = random_point(range), b = random_point(range), c = random_point(range),
                     d = random_point(range);
      ASSERT_EQ(sign(orient2d(a.flat(), b.flat(), c.flat())), sign_of(turn(a, b, c)));
      if (turn(a, b, c) <= 0) continue;
      const auto lift = [&d](const IntPoint& p) {
        return Int{p.x - d.x} * (p.x - d.x) + Int{p.y - d.y} * (p.y - d.y);
      };
      const Int expected =
          lift(a) * turn(b, c, d) + lift(b) * turn(c, a, d) + lift(c) * turn(a, b, d);
      ASSERT_EQ(sign(incircle(a.flat(), b.flat(), c.flat(), d.flat())), sign_of(expected));
    }
  }
}

TEST_F(Predicates, expansions_multiply_and_add_without_loss) {
  for (int i = 0; i < 2000; ++i) {
    std::uniform_int_distribution<std::int64_t> small(-(1LL << 40), 1LL << 40);
    const std::int64_t a = small(random_), b = small(random_), c = small(random_);
    const auto value = [](std::int64_t n) { return exact_difference(static_cast<double>(n), 0); };
    const auto zero = value(a) * value(b) - value(b) * value(a);
    ASSERT_EQ(zero.length, 0U);
    const auto rest = value(a) * (value(b) + value(c)) - value(a) * value(b) - value(a) * value(c);
    ASSERT_EQ(rest.most_significant(), 0);
  }
}

}  // namespace
}  // namespace tetfarm
