#include "mesh/metric/metric2.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

namespace tetfarm {
namespace {

constexpr double degree = std::numbers::pi / 180;

double largest_entry(const Metric2& m) {
  return std::max({std::abs(m.xx), std::abs(m.xy), std::abs(m.yy)});
}

void expect_near(const Metric2& found, const Metric2& expected, double share) {
  const double error = share * largest_entry(expected);
  EXPECT_NEAR(found.xx, expected.xx, error);
  EXPECT_NEAR(found.xy, expected.xy, error);
  EXPECT_NEAR(found.yy, expected.yy, error);
}

double length_of_vector(const Metric2& m, const Vec2& v) { return std::sqrt(squared_length(m, v)); }

TEST(Metric2, of_sizes_measures_one_along_and_across) {
  for (const double angle : {0.0, 30.0, 45.0, 90.0, 135.0, -20.0}) {
    const Metric2 m = metric_of_sizes({2, 0.01, angle * degree});
    const double c = std::cos(angle * degree);
    const double s = std::sin(angle * degree);
    EXPECT_NEAR(length_of_vector(m, {2 * c, 2 * s}), 1, 1e-9) << angle;
    EXPECT_NEAR(length_of_vector(m, {-0.01 * s, 0.01 * c}), 1, 1e-12) << angle;
  }
}

TEST(Metric2, of_sizes_along_the_axes_is_diagonal) {
  expect_near(metric_of_sizes({0.5, 0.1, 0}), {4, 0, 100}, 1e-15);
  expect_near(metric_of_sizes({0.5, 0.1, 90 * degree}), {100, 0, 4}, 1e-15);
}

TEST(Metric2, of_sizes_at_45_degrees_has_equal_diagonal_entries) {
  // Thesis, figure 29: equation 10 has no value here.
  const Metric2 m = metric_of_sizes({1, 0.1, 45 * degree});
  expect_near(m, {50.5, -49.5, 50.5}, 1e-14);
}

TEST(Metric2, of_sizes_agrees_with_equation_10_clockwise_where_that_is_regular) {
  for (const double angle : {10.0, 30.0, 60.0, 80.0, 120.0, -25.0}) {
    const Metric2 m = metric_of_sizes({1, 0.25, angle * degree});
    const double clockwise = -angle * degree;
    const double b = (m.yy - m.xx) / (2 / std::tan(2 * clockwise));
    EXPECT_NEAR(m.xy, b, 1e-12) << angle;
  }
}

TEST(Metric2, eigenvalues_and_direction_come_back) {
  for (const double angle : {0.0, 30.0, 45.0, 80.0, -60.0}) {
    const Eigen2 e = eigen(metric_of_eigen({1e6, 4, angle * degree}));
    EXPECT_NEAR(e.first, 1e6, 1e-8);
    EXPECT_NEAR(e.second, 4, 1e-8);
    EXPECT_NEAR(e.angle, angle * degree, 1e-12);
  }
}

TEST(Metric2, eigen_of_an_isotropic_matrix_is_finite_and_of_a_nearly_isotropic_one_close) {
  const Eigen2 same = eigen({3, 0, 3});
  EXPECT_EQ(same.first, 3);
  EXPECT_EQ(same.second, 3);
  EXPECT_EQ(same.angle, 0);
  for (const double off : {1e-4, 1e-8, 1e-12, 1e-16}) {
    const Eigen2 e = eigen({3, off, 3});
    EXPECT_NEAR(e.first, 3 + off, 4e-15);
    EXPECT_NEAR(e.second, 3 - off, 4e-15);
    EXPECT_NEAR(e.angle, 45 * degree, 1e-12);
    EXPECT_GE(e.first, e.second);
  }
  expect_near(metric_of_eigen(eigen({5, 1e-9, 5 + 1e-9})), {5, 1e-9, 5 + 1e-9}, 1e-15);
}

TEST(Metric2, eigen_of_a_matrix_with_negative_eigenvalues_puts_the_smaller_second) {
  const Eigen2 e = eigen(metric_of_eigen({-1, -1e5, 20 * degree}));
  EXPECT_NEAR(e.first, -1, 1e-9);
  EXPECT_NEAR(e.second, -1e5, 1e-9);
  EXPECT_NEAR(e.angle, 20 * degree, 1e-12);
}

TEST(Metric2, determinant_keeps_its_digits_at_an_aspect_of_1e7) {
  // (n + 3)(n - 2) - n² = n - 6
  constexpr double n = 1e14;
  EXPECT_EQ(determinant({n + 3, n, n - 2}), n - 6);
  EXPECT_EQ(determinant({n + 3, -n, n - 2}), n - 6);
  EXPECT_EQ(determinant({2, 1, 3}), 5);
}

TEST(Metric2, exponential_undoes_the_logarithm_up_to_an_aspect_of_1e5) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> share(0, 1);
  for (const double aspect : {1.0, 1.0 + 1e-9, 1.001, 10.0, 1e3, 1e5}) {
    for (int round = 0; round < 100; ++round) {
      const double size = std::pow(10, 4 * share(random) - 3);
      const Metric2 m = metric_of_sizes({size, size / aspect, std::numbers::pi * share(random)});
      expect_near(exp_of(log_of(m)), m, 2e-13);
      // The digits of the smaller eigenvalue go with the square of the aspect.
      EXPECT_NEAR(eigen(exp_of(log_of(m))).second * size * size, 1,
                  1e-15 * aspect * aspect + 1e-13);
    }
  }
}

TEST(Metric2, logarithm_of_a_diagonal_metric_is_that_of_its_entries) {
  expect_near(log_of({std::exp(2.0), 0, std::exp(-3.0)}), {2, 0, -3}, 1e-15);
  EXPECT_EQ(log_of({1, 0, 1}), (Metric2{0, 0, 0}));
  EXPECT_EQ(exp_of({0, 0, 0}), (Metric2{1, 0, 1}));
}

Metric2 log_mean(const Metric2& a, const Metric2& b) {
  const Metric2 p = log_of(a);
  const Metric2 q = log_of(b);
  return exp_of({(p.xx + q.xx) / 2, (p.xy + q.xy) / 2, (p.yy + q.yy) / 2});
}

TEST(Metric2, log_euclidean_mean_of_commuting_metrics_takes_geometric_means_of_eigenvalues) {
  for (const double angle : {0.0, 33.0, 45.0, 77.0}) {
    const Metric2 mean = log_mean(metric_of_eigen({1e4, 1, angle * degree}),
                                  metric_of_eigen({4, 100, angle * degree}));
    expect_near(mean, metric_of_eigen({200, 10, angle * degree}), 1e-13);
  }
}

TEST(Metric2, log_euclidean_mean_has_the_geometric_mean_of_the_determinants) {
  std::mt19937_64 random(12);
  std::uniform_real_distribution<double> share(0, 1);
  for (int round = 0; round < 1000; ++round) {
    const Metric2 a = metric_of_sizes({1, std::pow(10, -2 * share(random)), 3 * share(random)});
    const Metric2 b = metric_of_sizes({0.1, std::pow(10, -3 * share(random)), 3 * share(random)});
    const double det = determinant(log_mean(a, b));
    EXPECT_GE(det, std::min(determinant(a), determinant(b)) * (1 - 1e-9));
    EXPECT_LE(det, std::max(determinant(a), determinant(b)) * (1 + 1e-9));
    EXPECT_NEAR(det / std::sqrt(determinant(a) * determinant(b)), 1, 1e-8);
  }
}

TEST(Metric2, product_is_symmetric_and_gives_the_squared_length) {
  const Metric2 m{3, -1, 2};
  const Vec2 u{0.5, 2};
  const Vec2 v{-1, 0.25};
  EXPECT_DOUBLE_EQ(product(m, u, v), product(m, v, u));
  EXPECT_DOUBLE_EQ(product(m, u, u), squared_length(m, u));
  EXPECT_DOUBLE_EQ(squared_length(m, {1, 1}), 3);
}

TEST(Metric2, length_between_is_symmetric_and_between_its_ends) {
  std::mt19937_64 random(13);
  std::uniform_real_distribution<double> power(-4, 4);
  for (int round = 0; round < 10000; ++round) {
    const double a = std::pow(10, power(random));
    const double b = round % 3 == 0 ? a * (1 + 1e-3 * power(random)) : std::pow(10, power(random));
    const double length = length_between(a, b);
    EXPECT_NEAR(length_between(b, a), length, 1e-14 * length);
    EXPECT_GE(length, std::min(a, b) * (1 - 1e-15));
    EXPECT_LE(length, std::max(a, b) * (1 + 1e-15));
    // The logarithmic mean lies between the geometric and the arithmetic one.
    EXPECT_GE(length, std::sqrt(a * b) * (1 - 1e-14));
    EXPECT_LE(length, (a + b) / 2 * (1 + 1e-14));
  }
  EXPECT_DOUBLE_EQ(length_between(1, std::numbers::e), std::numbers::e - 1);
}

TEST(Metric2, length_between_is_continuous_where_the_ends_are_equal) {
  EXPECT_EQ(length_between(2, 2), 2);
  for (double off = 1e-16; off < 0.5; off *= 1.5) {
    const double x = off / 2;
    // In long doubles, by the definition.
    const long double a = 1;
    const long double b = 1 + static_cast<long double>(off);
    const long double exact =
        off < 1e-9 ? 1 + static_cast<long double>(x) : (b - a) / std::log(b / a);
    EXPECT_NEAR(length_between(1, static_cast<double>(b)), static_cast<double>(exact), 2e-14)
        << off;
  }
}

TEST(Metric2, share_at_length_is_one_half_of_an_even_edge_and_keeps_the_ends) {
  EXPECT_EQ(share_at_length(2, 2, 0.5), 0.5);
  EXPECT_NEAR(share_at_length(2, 2 + 1e-5, 0.5), 0.5, 1e-5);
  for (const double b : {1e-4, 0.3, 1.0, 7.0, 1e4}) {
    EXPECT_NEAR(share_at_length(1, b, 0), 0, 1e-15);
    EXPECT_NEAR(share_at_length(1, b, 1), 1, 1e-12);
  }
}

TEST(Metric2, share_at_length_is_monotone_and_mirrored_from_the_other_end) {
  for (const double b : {1e-4, 0.3, 1.0, 7.0, 1e4}) {
    double before = 0;
    for (int i = 1; i < 100; ++i) {
      const double share = share_at_length(1, b, i / 100.0);
      EXPECT_GT(share, before);
      EXPECT_LT(share, 1);
      EXPECT_NEAR(share_at_length(b, 1, 1 - i / 100.0), 1 - share, 1e-9);
      before = share;
    }
  }
}

TEST(Metric2, share_at_length_divides_an_edge_into_the_metric_lengths_asked_for) {
  for (const double b : {0.01, 0.5, 0.999, 1.001, 3.0, 200.0}) {
    const double a = 2;
    const double whole = length_between(a, b);
    for (const double part : {0.1, 0.5, 0.8}) {
      const double share = share_at_length(a, b, part);
      // Sizes grow geometrically, so the edge has a^(1-t) b^t at the share t.
      const double there = a * std::pow(b / a, share);
      EXPECT_NEAR(share * length_between(a, there), part * whole, 1e-10 * whole);
      EXPECT_NEAR((1 - share) * length_between(there, b), (1 - part) * whole, 1e-10 * whole);
    }
  }
}

TEST(Metric2, is_metric_refuses_what_measures_no_lengths) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  constexpr double inf = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(is_metric({1, 0, 1}));
  EXPECT_TRUE(is_metric({1e10, 0, 1e-10}));
  EXPECT_TRUE(is_metric({1, 0.999999999, 1}));
  EXPECT_FALSE(is_metric({nan, 0, 1}));
  EXPECT_FALSE(is_metric({1, nan, 1}));
  EXPECT_FALSE(is_metric({1, 0, nan}));
  EXPECT_FALSE(is_metric({inf, 0, 1}));
  EXPECT_FALSE(is_metric({1, 0, inf}));
  EXPECT_FALSE(is_metric({0, 0, 1}));
  EXPECT_FALSE(is_metric({1, 0, 0}));
  EXPECT_FALSE(is_metric({0, 0, 0}));
  EXPECT_FALSE(is_metric({-1, 0, -1})) << "positive determinant, negative definite";
  EXPECT_FALSE(is_metric({-1, 0, 1}));
  EXPECT_FALSE(is_metric({1, 1, 1}));
  EXPECT_FALSE(is_metric({1, 2, 1}));
  EXPECT_FALSE(is_metric({1, -2, 1}));
}

}  // namespace
}  // namespace tetfarm
