/// Metrics of the plane: symmetric positive definite matrices that say, at a point, how long an
/// edge of each direction may be. An edge of metric length 1 has the size that is asked for.
///
/// Source: thesis 3.2, equation 3 (length), 3.2.1 (ellipses). Equation 10 of the thesis, which is
/// singular at 45 degrees, is replaced by the rotation of the two sizes. Log-Euclidean means: V.
/// Arsigny, P. Fillard, X. Pennec, N. Ayache (2006).
/// Units: entries are 1/length². Determinants are taken without cancellation, so that metrics keep
/// their digits up to an aspect of 1e7. Cost: a few dozen flops each.
#pragma once

#include <cmath>

#include "mesh/geometry/predicates.h"

namespace tetfarm {

/// The matrix [xx xy; xy yy]; also the logarithm of one, which may be any symmetric matrix.
struct Metric2 {
  double xx = 1;
  double xy = 0;
  double yy = 1;
  friend bool operator==(const Metric2&, const Metric2&) = default;
};

/// Eigenvalues with the angle (radians, anticlockwise from x) of the direction of the first.
struct Eigen2 {
  double first = 0;
  double second = 0;
  double angle = 0;
};

/// Sizes h along `angle` and across it: eigenvalues 1/h².
struct MetricSizes {
  double along = 1;
  double across = 1;
  double angle = 0;
};

Metric2 metric_of_sizes(const MetricSizes& sizes);
/// The smaller eigenvalue comes second. @pre finite entries
Eigen2 eigen(const Metric2& m);
Metric2 metric_of_eigen(const Eigen2& eigen);

/// xx yy - xy², correct to a few units in the last place.
double determinant(const Metric2& m);
/// Finite, and positive definite.
bool is_metric(const Metric2& m);

/// @pre is_metric
Metric2 log_of(const Metric2& m);
/// Of any symmetric matrix.
Metric2 exp_of(const Metric2& log);

/// Lengths become longer by the square root of the factor.
inline Metric2 operator*(double factor, const Metric2& m) {
  return {factor * m.xx, factor * m.xy, factor * m.yy};
}

/// u · M v.
inline double product(const Metric2& m, const Vec2& u, const Vec2& v) {
  return u.x * (m.xx * v.x + m.xy * v.y) + u.y * (m.xy * v.x + m.yy * v.y);
}
/// The square of the length of v.
inline double squared_length(const Metric2& m, const Vec2& v) {
  return m.xx * v.x * v.x + 2 * m.xy * v.x * v.y + m.yy * v.y * v.y;
}

/// The metric length of an edge with lengths a and b by the metrics of its two ends, where the size
/// grows geometrically between them: (a - b) / ln(a / b).
inline double length_between(double a, double b) {
  const double difference = a - b;
  const double sum = a + b;
  // With x = difference / sum the length is difference / (2 atanh x); near x = 0 as a series.
  const double x = difference / sum;
  const double square = x * x;
  if (square < 1e-3) {
    return sum / 2 /
           (1 + square * (1.0 / 3 + square * (1.0 / 5 + square * (1.0 / 7 + square / 9))));
  }
  return difference / std::log(a / b);
}

/// The same of an edge by the metrics at its two ends.
inline double length_between(const Vec2& edge, const Metric2& a, const Metric2& b) {
  return length_between(std::sqrt(squared_length(a, edge)), std::sqrt(squared_length(b, edge)));
}

/// Where along such an edge, as a share of it from the end of length a, a metric length `part` of
/// its whole length has been passed.
double share_at_length(double a, double b, double part);

}  // namespace tetfarm
