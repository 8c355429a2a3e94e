#include "mesh/metric/metric_intersection.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace tetfarm {
namespace {

constexpr double right_angle = std::numbers::pi / 2;

double size_of_entries(const Metric2& m) {
  return std::max({std::abs(m.xx), std::abs(m.xy), std::abs(m.yy)});
}

double difference_of(const Metric2& a, const Metric2& b) {
  return size_of_entries({a.xx - b.xx, a.xy - b.xy, a.yy - b.yy});
}

class RandomMetrics {
 public:
  RandomMetrics(std::uint64_t seed, double aspect) : random_(seed), aspect_(aspect) {}
  Metric2 operator()() {
    const double size = std::pow(10, -2 * share_(random_));
    return metric_of_sizes(
        {size, size * std::pow(aspect_, -share_(random_)), 2 * right_angle * share_(random_)});
  }

 private:
  std::mt19937_64 random_;
  double aspect_;
  std::uniform_real_distribution<double> share_{0, 1};
};

/// The largest share by which m is less dense than the other in 64 directions and in the
/// direction where the other is densest; 0 when nowhere.
double least_missing(const Metric2& m, const Metric2& other) {
  double missing = 0;
  const double steepest = eigen(other).angle;
  for (int i = 0; i <= 64; ++i) {
    const double angle = i == 64 ? steepest : 2 * right_angle * i / 64;
    const Vec2 v{std::cos(angle), std::sin(angle)};
    missing = std::max(missing, squared_length(other, v) - squared_length(m, v));
  }
  return missing / size_of_entries(m);
}

TEST(MetricIntersection, of_a_metric_with_itself_is_the_metric_bit_by_bit) {
  RandomMetrics next(1, 1e5);
  for (int round = 0; round < 1000; ++round) {
    const Metric2 m = next();
    EXPECT_EQ(intersection(m, m), m);
  }
}

TEST(MetricIntersection, is_commutative_bit_by_bit) {
  RandomMetrics next(2, 1e7);
  for (int round = 0; round < 100'000; ++round) {
    const Metric2 a = next();
    const Metric2 b = next();
    ASSERT_EQ(intersection(a, b), intersection(b, a));
  }
}

void expect_as_dense_and_idempotent(std::uint64_t seed, double aspect, double share) {
  RandomMetrics next(seed, aspect);
  double least = 0;
  double most_again = 0;
  for (int round = 0; round < 100'000; ++round) {
    const Metric2 a = next();
    const Metric2 b = next();
    const Metric2 both = intersection(a, b);
    ASSERT_TRUE(is_metric(both)) << round;
    if (round % 8 == 0) least = std::max({least, least_missing(both, a), least_missing(both, b)});
    for (const Metric2& m : {a, b}) {
      const double again = difference_of(intersection(both, m), both) / size_of_entries(both);
      most_again = std::max(most_again, again);
    }
  }
  EXPECT_LE(least, share);
  // Rounding the result to doubles moves its smaller eigenvalue.
  EXPECT_LE(most_again, 10 * share);
}

TEST(MetricIntersection, is_as_dense_as_both_and_idempotent_at_an_aspect_of_1e3) {
  expect_as_dense_and_idempotent(3, 1e3, 1e-12);
}

TEST(MetricIntersection, is_as_dense_as_both_and_idempotent_at_an_aspect_of_1e5) {
  expect_as_dense_and_idempotent(4, 1e5, 1e-9);
}

TEST(MetricIntersection, is_the_largest_ellipse_touching_both) {
  // Were it denser than needed, then so would be its determinant: by simultaneous reduction that of
  // the result is det A times the product of max(1, eigenvalues of A⁻¹ B).
  RandomMetrics next(5, 30);
  for (int round = 0; round < 10'000; ++round) {
    const Metric2 a = next();
    const Metric2 b = next();
    const double det = determinant(a);
    const double trace = (a.yy * b.xx - 2 * a.xy * b.xy + a.xx * b.yy) / det;
    const double product_of_both = determinant(b) / det;
    const double root = std::sqrt(std::max(trace * trace / 4 - product_of_both, 0.0));
    const double larger = trace / 2 + root;
    const double smaller = product_of_both / larger;
    const double expected = det * std::max(1.0, larger) * std::max(1.0, smaller);
    EXPECT_NEAR(determinant(intersection(a, b)) / expected, 1, 1e-8) << round;
  }
}

TEST(MetricIntersection, of_nested_ellipses_is_the_inner_one) {
  const Metric2 inner = metric_of_sizes({0.1, 0.01, 0.3});
  const Metric2 outer = metric_of_sizes({3, 2, 1.1});
  EXPECT_LE(difference_of(intersection(inner, outer), inner), 1e-15 * size_of_entries(inner));
  EXPECT_LE(difference_of(intersection(outer, inner), inner), 1e-15 * size_of_entries(inner));
}

TEST(MetricIntersection, of_commuting_metrics_takes_the_larger_eigenvalue_of_each_direction) {
  for (const double angle : {0.0, 0.4, right_angle / 2, 1.3}) {
    const Metric2 both =
        intersection(metric_of_eigen({100, 1, angle}), metric_of_eigen({4, 9, angle}));
    EXPECT_LE(difference_of(both, metric_of_eigen({100, 9, angle})), 1e-12) << angle;
  }
  EXPECT_EQ(intersection({100, 0, 1}, {4, 0, 9}), (Metric2{100, 0, 9}));
}

TEST(MetricIntersection, of_crossing_line_metrics_is_isotropic) {
  // Thesis, figures 29 and 30.
  const Metric2 both = intersection(metric_of_sizes({1, 0.1, right_angle / 2}),
                                    metric_of_sizes({1, 0.1, -right_angle / 2}));
  EXPECT_LE(difference_of(both, {100, 0, 100}), 1e-12);
}

TEST(MetricIntersection, of_several_takes_them_in_the_order_given) {
  const std::array<Metric2, 3> metrics{metric_of_sizes({1, 0.1, 0.2}),
                                       metric_of_sizes({1, 0.05, 0.9}),
                                       metric_of_sizes({0.3, 0.2, 2.0})};
  EXPECT_EQ(intersection(metrics), intersection(intersection(metrics[0], metrics[1]), metrics[2]));
  for (const Metric2& m : metrics) EXPECT_LE(least_missing(intersection(metrics), m), 1e-12);
  EXPECT_EQ(intersection(std::span(metrics).first(1)), metrics[0]);
}

TEST(MetricIntersection, of_very_different_sizes_keeps_both) {
  const Metric2 both =
      intersection(metric_of_sizes({1e-6, 1, 0.5}), metric_of_sizes({1e3, 1e-3, 0.5}));
  const Eigen2 e = eigen(both);
  EXPECT_NEAR(e.first / 1e12, 1, 1e-12);
  EXPECT_NEAR(e.second / 1e6, 1, 1e-5);
}

}  // namespace
}  // namespace tetfarm
