#include "mesh/adaptation/circle_curve.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>

#include "mesh/adaptation/round_numbers.h"

namespace tetfarm {
namespace {

// Half the angle from the middle of an octant to its end is 11.25 degrees.
constexpr double largest_tangent = 0.198912367379658;
constexpr double half_sqrt2 = 0.7071067811865476;
constexpr int most_circle_steps = 40;

/// The middles of the octants.
constexpr std::array<Vec2, 8> middles{{{1, 0},
                                       {half_sqrt2, half_sqrt2},
                                       {0, 1},
                                       {-half_sqrt2, half_sqrt2},
                                       {-1, 0},
                                       {-half_sqrt2, -half_sqrt2},
                                       {0, -1},
                                       {half_sqrt2, -half_sqrt2}}};

/// A parameter as an octant, and the tangent of half the angle from its middle.
struct OctantPlace {
  std::size_t octant = 0;
  double tangent = 0;
};

OctantPlace octant_place(double eighths) {
  const double octant = std::clamp(std::floor(eighths), 0.0, 7.0);
  return {static_cast<std::size_t>(octant), (2 * (eighths - octant) - 1) * largest_tangent};
}

double largest_residual(const Circle& circle, std::span<const Vec2> nodes) {
  double largest = 0;
  for (const Vec2& p : nodes) {
    const double off = std::hypot(p.x - circle.centre.x, p.y - circle.centre.y) - circle.radius;
    largest = std::max(largest, std::abs(off));
  }
  return largest;
}

/// From the linear equations of x² + y² = 2 a x + 2 b y + c, about the mean of the nodes.
std::optional<Circle> algebraic_circle(std::span<const Vec2> nodes) {
  Vec2 mean;
  for (const Vec2& p : nodes) mean = {mean.x + p.x, mean.y + p.y};
  const auto count = static_cast<double>(nodes.size());
  mean = {mean.x / count, mean.y / count};
  Eigen::Matrix3d system = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  double extent = 0;
  for (const Vec2& p : nodes) extent = std::max(extent, std::hypot(p.x - mean.x, p.y - mean.y));
  if (!(extent > 0)) return std::nullopt;
  for (const Vec2& p : nodes) {
    const Eigen::Vector3d row((p.x - mean.x) / extent, (p.y - mean.y) / extent, 1);
    system += row * row.transpose();
    right += row * (row(0) * row(0) + row(1) * row(1));
  }
  Eigen::FullPivLU<Eigen::Matrix3d> lu(system);
  lu.setThreshold(1e-12);
  if (!lu.isInvertible()) return std::nullopt;
  const Eigen::Vector3d x = lu.solve(right);
  const double squared = x(2) + (x(0) * x(0) + x(1) * x(1)) / 4;
  if (!(squared > 0)) return std::nullopt;
  return Circle{{mean.x + extent * x(0) / 2, mean.y + extent * x(1) / 2},
                extent * std::sqrt(squared)};
}

Circle improved(Circle circle, std::span<const Vec2> nodes) {
  for (int step = 0; step < most_circle_steps; ++step) {
    Eigen::Matrix3d system = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    for (const Vec2& p : nodes) {
      const Vec2 from{p.x - circle.centre.x, p.y - circle.centre.y};
      const double distance = std::hypot(from.x, from.y);
      if (!(distance > 0)) continue;
      const Eigen::Vector3d row(from.x / distance, from.y / distance, 1);
      system += row * row.transpose();
      right += row * (distance - circle.radius);
    }
    const Eigen::Vector3d change = system.ldlt().solve(right);
    if (!change.allFinite() || circle.radius + change(2) <= 0) break;
    circle.centre = {circle.centre.x + change(0), circle.centre.y + change(1)};
    circle.radius += change(2);
    if (change.norm() < 1e-15 * circle.radius) break;
  }
  return circle;
}

}  // namespace

double CircleCurve::length() const { return 6.283185307179586 * circle_.radius; }

Vec2 CircleCurve::at(double parameter) const {
  const OctantPlace place = octant_place(8 * (parameter / length()));
  const double w = place.tangent;
  const double cosine = (1 - w * w) / (1 + w * w);
  const double sine = 2 * w / (1 + w * w);
  const Vec2& middle = middles[place.octant];
  return {circle_.centre.x + circle_.radius * (middle.x * cosine - middle.y * sine),
          circle_.centre.y + circle_.radius * (middle.y * cosine + middle.x * sine)};
}

Vec2 CircleCurve::direction(double parameter) const {
  const Vec2 place = at(parameter);
  return {circle_.centre.y - place.y, place.x - circle_.centre.x};
}

double CircleCurve::nearest(const Vec2& p) const {
  const Vec2 from{p.x - circle_.centre.x, p.y - circle_.centre.y};
  std::size_t octant = 0;
  double largest = from.x;
  for (std::size_t k = 1; k < middles.size(); ++k) {
    const double along = from.x * middles[k].x + from.y * middles[k].y;
    if (along > largest) {
      largest = along;
      octant = k;
    }
  }
  const Vec2& middle = middles[octant];
  const double across = middle.x * from.y - middle.y * from.x;
  const double w = across / (std::hypot(from.x, from.y) + largest);
  const double share = std::clamp(0.5 * (1 + w / largest_tangent), 0.0, 1.0);
  const double parameter = (static_cast<double>(octant) + share) / 8 * length();
  return parameter < length() ? parameter : 0;
}

std::optional<Circle> fitted_circle(std::span<const Vec2> nodes) {
  if (nodes.size() < 3) return std::nullopt;
  const std::optional<Circle> start = algebraic_circle(nodes);
  if (!start.has_value()) return std::nullopt;
  const Circle fitted = improved(*start, nodes);
  const double off = largest_residual(fitted, nodes);
  for (const double step : round_steps(fitted.radius)) {
    const Circle tried{{rounded_to(fitted.centre.x, step), rounded_to(fitted.centre.y, step)},
                       rounded_to(fitted.radius, step)};
    if (tried.radius > 0 && is_as_good(largest_residual(tried, nodes), off, fitted.radius)) {
      return tried;
    }
  }
  return fitted;
}

}  // namespace tetfarm
