#include "mesh/adaptation/metric_quality.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "base/array_index.h"
#include "base/check.h"

namespace tetfarm {
namespace {

Vec2 edge_from(const Vec2& a, const Vec2& b) { return {b.x - a.x, b.y - a.y}; }

/// The largest angle so far, by its sine and cosine, but for scale.
struct LargestAngle {
  double sine = 0, cosine = 1;

  /// Of the triangle's angles; without an arc tangent for each.
  void note(const std::array<Vec2, 3>& p) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec2 u = edge_from(p[i], p[(i + 1) % 3]);
      const Vec2 v = edge_from(p[i], p[(i + 2) % 3]);
      const double of_sine = u.x * v.y - u.y * v.x;
      const double of_cosine = u.x * v.x + u.y * v.y;
      // Angles are within half a turn, where the cotangent falls.
      if (of_cosine * sine >= cosine * of_sine) continue;
      sine = of_sine;
      cosine = of_cosine;
    }
  }
  double degrees() const { return std::atan2(sine, cosine) * 180 / std::numbers::pi; }
};

double quality_of(const std::array<Vec2, 3>& p, const Metric2& densest) {
  const Vec2 u = edge_from(p[0], p[1]);
  const Vec2 v = edge_from(p[0], p[2]);
  const double area = (u.x * v.y - u.y * v.x) / 2;
  const double squares = squared_length(densest, u) + squared_length(densest, v) +
                         squared_length(densest, edge_from(p[1], p[2]));
  return 4 * std::numbers::sqrt3 * area * std::sqrt(determinant(densest)) / squares;
}

}  // namespace

MetricQuality metric_quality(const TriangleComplex& complex, std::span<const Metric2> metrics) {
  TF_CHECK(complex.size() > 0 && metrics.size() == complex.points.size());
  MetricQuality result;
  result.edge_length_min = std::numeric_limits<double>::infinity();
  std::int64_t edges = 0;
  std::int64_t unit_edges = 0;
  std::vector<double> qualities;
  qualities.reserve(at(complex.size()));
  LargestAngle largest;
  double sum = 0;
  for (std::int32_t t = 0; t < complex.size(); ++t) {
    const TriangleComplex::Nodes& n = complex.nodes(t);
    std::array<Vec2, 3> p;
    std::size_t densest = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      p[i] = complex.point(n[i]);
      const double density = determinant(metrics[at(n[i])]);
      if (density > determinant(metrics[at(n[densest])])) densest = i;
    }
    for (std::size_t i = 0; i < 3; ++i) {
      const EdgeHandle other = complex.neighbour(t, static_cast<int>(i));
      if (other != no_edge && triangle_of(other) < t) continue;
      const Vec2& a = p[(i + 1) % 3];
      const Vec2& b = p[(i + 2) % 3];
      const double length =
          length_between(edge_from(a, b), metrics[at(n[(i + 1) % 3])], metrics[at(n[(i + 2) % 3])]);
      ++edges;
      unit_edges += length >= std::numbers::sqrt2 / 2 && length <= std::numbers::sqrt2 ? 1 : 0;
      result.edge_length_min = std::min(result.edge_length_min, length);
      if (length > result.edge_length_max) {
        result.edge_length_max = length;
        result.longest_at = {(a.x + b.x) / 2, (a.y + b.y) / 2};
      }
    }
    const double quality = quality_of(p, metrics[at(n[densest])]);
    qualities.push_back(quality);
    sum += quality;
    if (quality < result.quality_min) {
      result.quality_min = quality;
      result.worst_at = {(p[0].x + p[1].x + p[2].x) / 3, (p[0].y + p[1].y + p[2].y) / 3};
    }
    largest.note(p);
  }
  result.max_angle_deg = largest.degrees();
  result.unit_edges_percent = 100 * static_cast<double>(unit_edges) / static_cast<double>(edges);
  result.quality_mean = sum / static_cast<double>(qualities.size());
  const auto hundredth = qualities.begin() + static_cast<std::ptrdiff_t>(qualities.size() / 100);
  std::nth_element(qualities.begin(), hundredth, qualities.end());
  result.quality_1percent = *hundredth;
  return result;
}

}  // namespace tetfarm
