#include "mesh/adaptation/metric_scaling.h"

#include <gmock/gmock.h>

#include <cmath>
#include <vector>

#include "base/error.h"
#include "mesh/adaptation/checked_plane_mesh.h"
#include "tests/mesh/adaptation/plane_shapes.h"

namespace tetfarm {
namespace {

TriangleComplex unit_grid(int n) { return checked_complex(plane_test::square(n)); }

std::vector<Metric2> everywhere(const TriangleComplex& complex, const Metric2& metric) {
  return std::vector<Metric2>(complex.points.size(), metric);
}

double smaller_size(const Metric2& m) { return 1 / std::sqrt(eigen(m).first); }
double larger_size(const Metric2& m) { return 1 / std::sqrt(eigen(m).second); }

TEST(MetricScaling, limits_sizes_and_makes_the_larger_smaller_for_the_aspect) {
  const Metric2 wild = metric_of_sizes({1e-6, 1e3, 0.4});
  const Metric2 sized = limited(wild, {1e-3, 10, 1e7, 0});
  EXPECT_NEAR(smaller_size(sized), 1e-3, 1e-9);
  EXPECT_NEAR(larger_size(sized), 10, 1e-3);
  const Metric2 shaped = limited(wild, {0, 0, 100, 0});
  EXPECT_NEAR(smaller_size(shaped) / 1e-6, 1, 1e-6);
  EXPECT_NEAR(larger_size(shaped) / 1e-4, 1, 1e-6);
  EXPECT_NEAR(eigen(shaped).angle, 0.4, 1e-6);
}

TEST(MetricScaling, complexity_is_the_area_over_that_of_a_unit_square) {
  const TriangleComplex complex = unit_grid(4);
  EXPECT_NEAR(complexity(complex, everywhere(complex, metric_of_sizes({0.1, 0.01, 0.3}))), 1000,
              1e-6);
}

TEST(MetricScaling, gradation_lets_sizes_grow_no_faster_along_any_edge) {
  const TriangleComplex complex = unit_grid(20);
  std::vector<Metric2> metrics = everywhere(complex, metric_of_sizes({10, 10, 0}));
  metrics[complex.points.size() / 2] = metric_of_sizes({1e-3, 1e-2, 0.7});
  const double gradation = 1.5;
  const std::vector<Metric2> result = graded(complex, metrics, gradation);
  for (std::int32_t t = 0; t < complex.size(); ++t) {
    for (int i = 0; i < 3; ++i) {
      const auto a = static_cast<std::size_t>(complex.node(t, i));
      const auto b = static_cast<std::size_t>(complex.node(t, next(i)));
      const Vec2 edge{complex.points[b].x - complex.points[a].x,
                      complex.points[b].y - complex.points[a].y};
      const double growth = 1 + std::sqrt(squared_length(result[a], edge)) * std::log(gradation);
      const Metric2 rest{result[b].xx * (1 + 1e-6) - result[a].xx / growth / growth,
                         result[b].xy * (1 + 1e-6) - result[a].xy / growth / growth,
                         result[b].yy * (1 + 1e-6) - result[a].yy / growth / growth};
      EXPECT_GE(rest.xx, 0);
      EXPECT_GE(determinant(rest), 0);
    }
  }
  EXPECT_EQ(result[complex.points.size() / 2], metrics[complex.points.size() / 2]);
  EXPECT_LT(larger_size(result.front()), 3);
}

TEST(MetricScaling, gradation_that_is_off_changes_no_bit) {
  const TriangleComplex complex = unit_grid(3);
  std::vector<Metric2> metrics = everywhere(complex, metric_of_sizes({1, 1, 0}));
  metrics.front() = metric_of_sizes({1e-5, 1, 0});
  EXPECT_EQ(graded(complex, metrics, 0), metrics);
}

TEST(MetricScaling, finds_the_complexity_with_all_limits_in_force) {
  const TriangleComplex complex = unit_grid(30);
  std::vector<Metric2> wish;
  for (const Vec2& p : complex.points) {
    wish.push_back(metric_of_sizes({0.001 + std::abs(p.x - 0.5), 1, 0}));
  }
  for (const double wanted : {200.0, 5000.0, 300'000.0}) {
    const ScaledMetric result = scaled_to(complex, wish, {1e-4, 0.3, 50, 1.3}, wanted);
    EXPECT_NEAR(result.complexity / wanted, 1, 0.011) << wanted;
    EXPECT_NEAR(complexity(complex, result.metrics), result.complexity, 1e-9 * wanted);
    EXPECT_GT(result.at_aspect + result.at_h_max + result.by_gradation, 0);
  }
}

TEST(MetricScaling, says_what_limits_allow_that_do_not_let_it) {
  const TriangleComplex complex = unit_grid(4);
  const std::vector<Metric2> wish = everywhere(complex, metric_of_sizes({1, 1, 0}));
  const auto message = [&](const MetricLimits& limits, double wanted) -> std::string {
    try {
      scaled_to(complex, wish, limits, wanted);
    } catch (const InvalidInput& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_THAT(message({0.1, 0, 1e4, 0}, 1e6), ::testing::HasSubstr("about 118 vertices"));
  EXPECT_THAT(message({0.1, 0, 1e4, 0}, 1e6), ::testing::HasSubstr("--h-min too large"));
  EXPECT_THAT(message({0, 0.1, 1e4, 0}, 10), ::testing::HasSubstr("--h-max too small"));
}

TEST(MetricScaling, lp_metrics_weigh_weak_features_by_the_norm) {
  const std::vector<Metric2> hessians{{100, 0, 100}, {-1, 0, 1}};
  const auto ratio = [&](double norm) {
    const std::vector<Metric2> m = lp_metrics(hessians, norm);
    return std::sqrt(determinant(m[0]) / determinant(m[1]));
  };
  // det^(p/(2p+2)) of the determinants 1e4 and 1, square root of those of the metrics.
  EXPECT_NEAR(ratio(1), std::pow(1e4, 1.0 / 4), 1e-9);
  EXPECT_NEAR(ratio(2), std::pow(1e4, 2.0 / 6), 1e-9);
  EXPECT_LT(ratio(1), ratio(10));
}

TEST(LpMetrics, tell_weak_flow_far_away_from_none) {
  const double weak = 1e-10;  // of the largest, as some chords from a wing
  const std::vector<Metric2> metrics =
      lp_metrics(std::vector<Metric2>{{1, 0, 1}, {weak, 0, weak}, {weak / 10, 0, weak / 10}}, 2);
  // h of |H| det^(-1/6): the density goes as |H| to the power of 2/3.
  EXPECT_NEAR(metrics[1].xx / metrics[0].xx / std::pow(weak, 2.0 / 3), 1, 1e-9);
  EXPECT_NEAR(metrics[2].xx / metrics[1].xx / std::pow(0.1, 2.0 / 3), 1, 1e-9);
}

TEST(MetricScaling, of_a_field_without_second_derivatives_asks_for_the_same_everywhere) {
  const std::vector<Metric2> flat(5, Metric2{0, 0, 0});
  for (const Metric2& m : lp_metrics(flat, 2)) {
    EXPECT_TRUE(is_metric(m));
    EXPECT_EQ(m, lp_metrics(flat, 2).front());
  }
}

}  // namespace
}  // namespace tetfarm
