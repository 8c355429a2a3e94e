#include "mesh/adaptation/metric_field.h"

#include <algorithm>
#include <array>
#include <utility>

#include "base/array_index.h"
#include "base/check.h"

namespace tetfarm {
namespace {

// A walk through a mesh without obtuse traps is far shorter; this only ends one that goes round.
constexpr int longest_walk = 100'000;

double turn(const Vec2& a, const Vec2& b, const Vec2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Twice the signed areas of the three triangles of p with the edges opposite nodes 0, 1, 2.
std::array<double, 3> areas_at(const TriangleComplex& complex, std::int32_t t, const Vec2& p) {
  const TriangleComplex::Nodes& n = complex.nodes(t);
  const Vec2& a = complex.point(n[0]);
  const Vec2& b = complex.point(n[1]);
  const Vec2& c = complex.point(n[2]);
  return {turn(b, c, p), turn(c, a, p), turn(a, b, p)};
}

}  // namespace

MetricField::MetricField(TriangleComplex background, std::span<const Metric2> metrics)
    : background_(std::move(background)) {
  TF_CHECK(metrics.size() == background_.points.size());
  logs_.reserve(metrics.size());
  for (const Metric2& m : metrics) logs_.push_back(log_of(m));
}

Metric2 MetricField::at(const Vec2& point, std::int32_t& home) const {
  TF_CHECK(home >= 0 && home < background_.size());
  EdgeHandle entered = no_edge;
  std::array<double, 3> areas = areas_at(background_, home, point);
  for (int step = 0; step < longest_walk; ++step) {
    int worst = -1;
    for (int i = 0; i < 3; ++i) {
      const EdgeHandle beyond = background_.neighbour(home, i);
      if (areas[tetfarm::at(i)] >= 0 || beyond == no_edge || edge_handle(home, i) == entered)
        continue;
      if (worst < 0 || areas[tetfarm::at(i)] < areas[tetfarm::at(worst)]) worst = i;
    }
    if (worst < 0) break;
    entered = background_.neighbour(home, worst);
    home = triangle_of(entered);
    areas = areas_at(background_, home, point);
  }
  double sum = 0;
  for (double& area : areas) {
    area = std::max(area, 0.0);
    sum += area;
  }
  const TriangleComplex::Nodes& n = background_.nodes(home);
  Metric2 log{0, 0, 0};
  for (int i = 0; i < 3; ++i) {
    const Metric2& of_node = logs_[tetfarm::at(n[tetfarm::at(i)])];
    const double weight = sum > 0 ? areas[tetfarm::at(i)] / sum : 1.0 / 3;
    log.xx += weight * of_node.xx;
    log.xy += weight * of_node.xy;
    log.yy += weight * of_node.yy;
  }
  return exp_of(log);
}

}  // namespace tetfarm
