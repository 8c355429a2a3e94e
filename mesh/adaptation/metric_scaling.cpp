#include "mesh/adaptation/metric_scaling.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <utility>

#include "base/array_index.h"
#include "base/check.h"
#include "base/error.h"
#include "mesh/adaptation/sourced_complexity.h"
#include "mesh/metric/metric_intersection.h"

namespace tetfarm {
namespace {

constexpr double flat_share = 1e-6;      // of a field's largest second derivative
constexpr double lp_flat_share = 1e-12;  // far away from a wing some 1e-10 is flow
constexpr double straight_share = 1e-8;  // of a node's own largest: an aspect of 1e4
constexpr int most_rounds = 400;
constexpr int most_steps = 40;
constexpr double close_enough = 0.01;

/// Whether a - b has no negative eigenvalue, but for rounding.
bool covers(const Metric2& a, const Metric2& b) {
  const Metric2 rest{a.xx * (1 + 1e-9) - b.xx, a.xy * (1 + 1e-9) - b.xy, a.yy * (1 + 1e-9) - b.yy};
  return rest.xx >= 0 && rest.yy >= 0 && determinant(rest) >= 0;
}

/// The metric of `from` as far as the node at the other end of the edge may be from it.
Metric2 grown(const Metric2& from, const Vec2& edge, double log_gradation) {
  const double length = std::sqrt(squared_length(from, edge));
  const double growth = 1 + length * log_gradation;
  return (1 / (growth * growth)) * from;
}

/// Absolute eigenvalues, raised to a share of the field's largest and of the node's own.
std::vector<Metric2> raised(std::span<const Metric2> hessians, double share, double own_share) {
  double largest = 0;
  std::vector<Eigen2> eigenvalues;
  for (const Metric2& h : hessians) {
    Eigen2 e = eigen(h);
    e.first = std::abs(e.first);
    e.second = std::abs(e.second);
    largest = std::max({largest, e.first, e.second});
    eigenvalues.push_back(e);
  }
  // A field without any second derivative asks for the same everywhere.
  const double floor = largest > 0 ? share * largest : 1;
  std::vector<Metric2> metrics;
  for (Eigen2 e : eigenvalues) {
    const double least = std::max(floor, own_share * std::max(e.first, e.second));
    e.first = std::max(e.first, least);
    e.second = std::max(e.second, least);
    metrics.push_back(metric_of_eigen(e));
  }
  return metrics;
}

}  // namespace

Metric2 limited(const Metric2& metric, const MetricLimits& limits) {
  Eigen2 e = eigen(metric);
  const double largest = limits.h_min > 0 ? 1 / (limits.h_min * limits.h_min)
                                          : std::numeric_limits<double>::infinity();
  const double least = limits.h_max > 0 ? 1 / (limits.h_max * limits.h_max) : 0;
  e.first = std::clamp(e.first, least, largest);
  e.second = std::clamp(e.second, least, largest);
  e.second = std::max(e.second, e.first / (limits.aspect * limits.aspect));
  return metric_of_eigen(e);
}

std::vector<Metric2> graded(const TriangleComplex& complex, std::vector<Metric2> metrics,
                            double gradation) {
  TF_CHECK(metrics.size() == complex.points.size());
  if (gradation <= 1) return metrics;
  const double log_gradation = std::log(gradation);
  const std::vector<std::array<std::int32_t, 2>> edges = edges_of(complex);
  std::vector<std::uint8_t> changed(metrics.size(), 1);
  for (int round = 0; round < most_rounds; ++round) {
    std::vector<Metric2> next_metrics = metrics;
    std::vector<std::uint8_t> changes(metrics.size(), 0);
    bool is_done = true;
    const auto spread = [&](std::int32_t from, std::int32_t to, const Vec2& edge) {
      if (changed[at(from)] == 0) return;
      const Metric2 reached = grown(metrics[at(from)], edge, log_gradation);
      Metric2& there = next_metrics[at(to)];
      if (covers(there, reached)) return;
      there = intersection(there, reached);
      changes[at(to)] = 1;
      is_done = false;
    };
    for (const auto& [from, to] : edges) {
      const Vec2& a = complex.point(from);
      const Vec2& b = complex.point(to);
      const Vec2 edge{b.x - a.x, b.y - a.y};
      spread(from, to, edge);
      spread(to, from, edge);
    }
    metrics = std::move(next_metrics);
    changed = std::move(changes);
    if (is_done) break;
  }
  return metrics;
}

std::vector<Metric2> absolute(std::span<const Metric2> hessians) {
  return raised(hessians, flat_share, 0);
}

std::vector<Metric2> lp_metrics(std::span<const Metric2> hessians, double norm) {
  std::vector<Metric2> metrics = raised(hessians, lp_flat_share, straight_share);
  for (Metric2& m : metrics) m = std::pow(determinant(m), -1 / (2 * norm + 2)) * m;
  return metrics;
}

double complexity(const TriangleComplex& complex, std::span<const Metric2> metrics) {
  TF_CHECK(metrics.size() == complex.points.size());
  double sum = 0;
  for (const TriangleComplex::Nodes& n : complex.triangles) {
    const Vec2& p = complex.point(n[0]);
    const Vec2& q = complex.point(n[1]);
    const Vec2& r = complex.point(n[2]);
    const double area = ((q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x)) / 2;
    double density = 0;
    for (const std::int32_t v : n) density += std::sqrt(determinant(metrics[at(v)])) / 3;
    sum += area * density;
  }
  return sum;
}

namespace {

ScaledMetric at_scale(const TriangleComplex& complex, std::vector<Metric2> wish,
                      const MetricLimits& limits, const MetricSources* sources, double scale) {
  ScaledMetric result;
  result.scale = scale;
  for (Metric2& m : wish) {
    const Metric2 wished = (scale * scale) * m;
    const Eigen2 e = eigen(wished);
    result.at_h_min += limits.h_min > 0 && e.first * limits.h_min * limits.h_min > 1 ? 1 : 0;
    result.at_h_max += limits.h_max > 0 && e.second * limits.h_max * limits.h_max < 1 ? 1 : 0;
    result.at_aspect += e.first > limits.aspect * limits.aspect * e.second ? 1 : 0;
    m = limited(wished, limits);
  }
  result.metrics = std::move(wish);
  if (limits.gradation > 1) {
    const std::vector<Metric2> before = result.metrics;
    result.metrics = graded(complex, std::move(result.metrics), limits.gradation);
    for (std::size_t v = 0; v < before.size(); ++v) {
      result.by_gradation += before[v] == result.metrics[v] ? 0 : 1;
    }
  }
  if (sources == nullptr) {
    result.complexity = complexity(complex, result.metrics);
    return result;
  }
  SourcedComplexity sourced = sourced_complexity(complex, result.metrics, *sources);
  result.complexity = sourced.complexity;
  result.sources_act = std::move(sourced.acts);
  return result;
}

}  // namespace

ScaledMetric limited_metric(const TriangleComplex& complex, std::vector<Metric2> wish,
                            const MetricLimits& limits, const MetricSources* sources) {
  return at_scale(complex, std::move(wish), limits, sources, 1);
}

ScaledMetric scaled_to(const TriangleComplex& complex, std::span<const Metric2> wish,
                       const MetricLimits& limits, double wanted, const MetricSources* sources) {
  // Complexity rises with the square of the scale where no limit holds, and never falls.
  TF_CHECK(wanted > 0);
  double low = 0;
  double high = std::numeric_limits<double>::infinity();
  double scale = std::sqrt(wanted / complexity(complex, wish));
  ScaledMetric result;
  for (int step = 0; step < most_steps; ++step) {
    result = at_scale(complex, {wish.begin(), wish.end()}, limits, sources, scale);
    if (std::abs(result.complexity / wanted - 1) < close_enough) return result;
    (result.complexity < wanted ? low : high) = scale;
    double next_scale = scale * std::sqrt(wanted / result.complexity);
    if (std::isinf(high)) next_scale = std::max(next_scale, 1.05 * scale);
    if (low > 0 && high < std::numeric_limits<double>::infinity() &&
        (step > 6 || next_scale <= low || next_scale >= high)) {
      next_scale = std::sqrt(low * high);
    }
    if (low == 0) next_scale = std::min(next_scale, 0.95 * scale);
    scale = next_scale;
    if (high < low * (1 + 1e-9)) break;
  }
  std::array<char, 200> text{};
  std::snprintf(text.data(), text.size(),
                "with these limits a mesh has about %.0f vertices: they leave no way to %s",
                result.complexity * nodes_per_complexity,
                result.complexity < wanted ? "more (is --h-min too large?)"
                : sources != nullptr       ? "fewer (do the sources ask for so many?)"
                                           : "fewer (is --h-max too small?)");
  throw InvalidInput(text.data(), "--vertices");
}

}  // namespace tetfarm
