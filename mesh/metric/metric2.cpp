#include "mesh/metric/metric2.h"

#include <cmath>

#include "base/check.h"

namespace tetfarm {

Metric2 metric_of_sizes(const MetricSizes& sizes) {
  TF_CHECK(sizes.along > 0 && sizes.across > 0);
  return metric_of_eigen(
      {1 / (sizes.along * sizes.along), 1 / (sizes.across * sizes.across), sizes.angle});
}

Eigen2 eigen(const Metric2& m) {
  const double half_sum = (m.xx + m.yy) / 2;
  const double half_difference = (m.xx - m.yy) / 2;
  const double radius = std::hypot(half_difference, m.xy);
  const double angle = radius > 0 ? std::atan2(m.xy, half_difference) / 2 : 0;
  // Of the two, the one of larger magnitude is a sum without cancellation; the other follows from
  // the determinant.
  if (half_sum >= 0) {
    const double first = half_sum + radius;
    return {first, first > 0 ? determinant(m) / first : 0, angle};
  }
  const double second = half_sum - radius;
  return {determinant(m) / second, second, angle};
}

Metric2 metric_of_eigen(const Eigen2& eigen) {
  const double c = std::cos(eigen.angle);
  const double s = std::sin(eigen.angle);
  return {c * c * eigen.first + s * s * eigen.second, c * s * (eigen.first - eigen.second),
          s * s * eigen.first + c * c * eigen.second};
}

double determinant(const Metric2& m) {
  const double square = m.xy * m.xy;
  const double rest = std::fma(-m.xy, m.xy, square);
  return std::fma(m.xx, m.yy, -square) + rest;
}

bool is_metric(const Metric2& m) {
  return std::isfinite(m.xx) && std::isfinite(m.xy) && std::isfinite(m.yy) && m.xx > 0 &&
         m.yy > 0 && determinant(m) > 0;
}

Metric2 log_of(const Metric2& m) {
  const Eigen2 e = eigen(m);
  const double first = std::log(e.first);
  const double second = std::log(e.second);
  const double radius = (e.first - e.second) / 2;
  // log M = mean + slope (M - half sum): the slope is 1 / eigenvalue where both are the same.
  const double slope = radius > 1e-8 * e.first ? (first - second) / (2 * radius) : 1 / e.first;
  const double half_difference = slope * (m.xx - m.yy) / 2;
  const double mean = (first + second) / 2;
  return {mean + half_difference, slope * m.xy, mean - half_difference};
}

Metric2 exp_of(const Metric2& log) {
  const double mean = (log.xx + log.yy) / 2;
  const double half_difference = (log.xx - log.yy) / 2;
  const double radius = std::sqrt(half_difference * half_difference + log.xy * log.xy);
  const double large = std::exp(mean + radius);
  const double small = std::exp(mean - radius);
  const double half_sum = (large + small) / 2;
  const double slope = radius > 1e-8 ? (large - small) / (2 * radius) : half_sum;
  return {half_sum + slope * half_difference, slope * log.xy, half_sum - slope * half_difference};
}

double share_at_length(double a, double b, double part) {
  // The length passed at share t is a (r^t - 1) / ln r with r = b / a.
  const double log_ratio = std::log(b / a);
  if (std::abs(log_ratio) < 1e-6) return part;
  return std::log1p(part * std::expm1(log_ratio)) / log_ratio;
}

}  // namespace tetfarm
