#include "mesh/adaptation/true_curve.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/check.h"

namespace tetfarm {
namespace {

constexpr int most_foot_steps = 100;

double distance_from_segment(const Vec2& a, const Vec2& b, const Vec2& p) {
  const Vec2 chord{b.x - a.x, b.y - a.y};
  const double squared = chord.x * chord.x + chord.y * chord.y;
  const double along = (p.x - a.x) * chord.x + (p.y - a.y) * chord.y;
  const double share = squared > 0 ? std::clamp(along / squared, 0.0, 1.0) : 0;
  return std::hypot(a.x + share * chord.x - p.x, a.y + share * chord.y - p.y);
}

/// Below 0 before the foot of p, above behind it.
double behind_foot(const TrueCurve& curve, double parameter, const Vec2& p) {
  const Vec2 place = curve.at(parameter);
  const Vec2 direction = curve.direction(parameter);
  return (place.x - p.x) * direction.x + (place.y - p.y) * direction.y;
}

/// Of a point whose foot lies between the two parameters, or beyond one of them.
double foot_between(const TrueCurve& curve, double low, double high, const Vec2& p) {
  double of_low = behind_foot(curve, low, p);
  double of_high = behind_foot(curve, high, p);
  if (!(of_low < 0)) return low;
  if (!(of_high > 0)) return high;
  const double start_width = high - low;
  for (int step = 0; step < most_foot_steps; ++step) {
    double middle = low - of_low * (high - low) / (of_high - of_low);
    // Every third step halves: regula falsi alone may creep.
    if (step % 3 == 2 || !(middle > low && middle < high)) middle = low + (high - low) / 2;
    if (!(middle > low && middle < high)) break;
    const double of_middle = behind_foot(curve, middle, p);
    if (of_middle == 0) return middle;
    if (of_middle < 0) {
      low = middle;
      of_low = of_middle;
      of_high /= 2;
    } else {
      high = middle;
      of_high = of_middle;
      of_low /= 2;
    }
    if (high - low <= 1e-16 * start_width) break;
  }
  return low + (high - low) / 2;
}

}  // namespace

double TrueCurve::within(double parameter) const {
  if (!is_closed()) return parameter;
  parameter = std::fmod(parameter, length());
  return parameter < 0 ? parameter + length() : parameter;
}

double TrueCurve::way(double from, double to) const {
  const double way = to - from;
  return is_closed() ? std::remainder(way, length()) : way;
}

CurveSamples::CurveSamples(const TrueCurve& curve, std::vector<double> parameters)
    : parameters_(std::move(parameters)) {
  TF_CHECK(parameters_.size() >= 2);
  for (const double parameter : parameters_) points_.push_back(curve.at(parameter));
  for (std::size_t i = 0; i + 1 < points_.size(); ++i) {
    // A parabola is nowhere further from its chord than in the middle; twice that for safety.
    const Vec2 middle = curve.at((parameters_[i] + parameters_[i + 1]) / 2);
    sags_.push_back(2 * distance_from_segment(points_[i], points_[i + 1], middle));
  }
}

double CurveSamples::nearest(const TrueCurve& curve, const Vec2& p) const {
  std::vector<double> distances;
  distances.reserve(sags_.size());
  double reach = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < sags_.size(); ++i) {
    distances.push_back(distance_from_segment(points_[i], points_[i + 1], p));
    reach = std::min(reach, distances.back() + sags_[i]);
  }
  double best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < sags_.size(); ++i) {
    if (distances[i] - sags_[i] > reach) continue;
    const double foot = foot_between(curve, parameters_[i], parameters_[i + 1], p);
    const Vec2 place = curve.at(foot);
    const double distance = std::hypot(place.x - p.x, place.y - p.y);
    if (distance < least) {
      least = distance;
      best = foot;
    }
  }
  return best;
}

}  // namespace tetfarm
