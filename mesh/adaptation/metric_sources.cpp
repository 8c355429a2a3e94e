#include "mesh/adaptation/metric_sources.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/check.h"
#include "mesh/adaptation/naca_profile.h"
#include "mesh/metric/metric_intersection.h"

namespace tetfarm {
namespace {

// The longest edge of a triangle that holds a source is nowhere farther from it than it is long. So
// where it is much longer than the sizes of the source its length is nearly 1 / slope or
// more: 2.97, and it is divided.
const double noticeable_slope = std::log(1.4);
constexpr double infinity = std::numeric_limits<double>::infinity();

double length_of(const Vec2& v) { return std::sqrt(v.x * v.x + v.y * v.y); }

/// At most the smaller eigenvalue, and at least half of it.
double least_of(const Metric2& m) { return determinant(m) / (m.xx + m.yy); }

/// Whether lengths by a are as long as by b in every direction.
bool is_at_least(const Metric2& a, const Metric2& b) {
  const Metric2 rest{a.xx - b.xx, a.xy - b.xy, a.yy - b.yy};
  return rest.xx >= 0 && rest.yy >= 0 && rest.xx * rest.yy >= rest.xy * rest.xy;
}

/// Of one size in a direction and another across it.
Metric2 metric_along(const Vec2& direction, double along, double across) {
  const double first = 1 / (along * along);
  const double second = 1 / (across * across);
  const auto& [c, s] = direction;
  return {c * c * first + s * s * second, c * s * (first - second), s * s * first + c * c * second};
}

}  // namespace

MetricSources::MetricSources(const std::vector<MetricSource>& sources) {
  for (const MetricSource& s : sources) {
    TF_CHECK(s.along > 0 && s.across > 0 && s.radius > 0 && (s.growth == 0 || s.growth > 1));
    Source source;
    source.from = s.from;
    source.way = {s.to.x - s.from.x, s.to.y - s.from.y};
    source.square = source.way.x * source.way.x + source.way.y * source.way.y;
    const Vec2 turn = direction_of_angle(s.angle_deg);
    Vec2 along{1, 0};
    if (source.square > 0) {
      const double length = std::sqrt(source.square);
      along = {source.way.x / length, source.way.y / length};
    }
    along = {along.x * turn.x - along.y * turn.y, along.x * turn.y + along.y * turn.x};
    source.metric = metric_along(along, s.along, s.across);
    source.finest = std::min(s.along, s.across);
    source.most = 1 / (source.finest * source.finest);
    source.radius = s.radius;
    source.slope = s.growth > 1 ? std::log(s.growth) : 0;
    sources_.push_back(source);
  }
}

Vec2 MetricSources::from_axis(const Source& source, const Vec2& point) {
  Vec2 away{point.x - source.from.x, point.y - source.from.y};
  if (source.square > 0) {
    const double share =
        std::clamp((away.x * source.way.x + away.y * source.way.y) / source.square, 0.0, 1.0);
    away.x -= share * source.way.x;
    away.y -= share * source.way.y;
  }
  return away;
}

/// By how much sizes have grown; infinite where the source has ended.
double MetricSources::coarsening(const Source& source, const Vec2& point) {
  const Vec2 away = from_axis(source, point);
  const double distance = length_of(away);
  if (distance <= source.radius) return 1;
  if (source.slope <= 0) return infinity;
  const double beyond = 1 - source.radius / distance;
  return 1 + source.slope * beyond * std::sqrt(squared_length(source.metric, away));
}

Metric2 MetricSources::at(const Vec2& point, const Metric2& base, double factor) const {
  Metric2 all = base;
  double least = least_of(all);
  for (const Source& source : sources_) {
    const double coarser = coarsening(source, point);
    const double share = factor / (coarser * coarser);
    if (source.most * share <= least) continue;
    const Metric2 asked = share * source.metric;
    if (is_at_least(all, asked)) continue;
    all = intersection(all, asked);
    least = least_of(all);
  }
  return all;
}

bool MetricSources::acts(std::size_t source, const Vec2& point, const Metric2& base) const {
  const double coarser = coarsening(sources_[source], point);
  const Metric2 asked = (1 / (coarser * coarser)) * sources_[source].metric;
  // In some direction its lengths are longer by more than a thousandth.
  return !is_at_least(1.002 * base, asked);
}

bool MetricSources::is_noticeable() const {
  return std::all_of(sources_.begin(), sources_.end(), [](const Source& source) {
    return source.slope > 0 && source.slope <= noticeable_slope;
  });
}

MetricSources MetricSources::noticeable() const {
  MetricSources slow = *this;
  for (Source& source : slow.sources_) {
    source.slope = source.slope > 0 ? std::min(source.slope, noticeable_slope) : noticeable_slope;
  }
  return slow;
}

double MetricSources::piece_size(const Vec2& point) const {
  double size = infinity;
  for (const Source& source : sources_) {
    const double beyond = length_of(from_axis(source, point)) - source.radius;
    const double finest = std::max(source.radius / 2, source.finest);
    size = std::min(size, std::max(finest, 0.7 * std::abs(beyond)));
  }
  return size;
}

}  // namespace tetfarm
