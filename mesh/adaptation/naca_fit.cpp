#include "mesh/adaptation/naca_fit.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "mesh/adaptation/round_numbers.h"

namespace tetfarm {
namespace {

constexpr std::size_t most_nodes = 400;
constexpr int most_fitting_steps = 20;

using Parts = std::vector<std::shared_ptr<const TrueCurve>>;

struct Foot {
  const TrueCurve* part = nullptr;
  double parameter = 0;
  Vec2 point;
  double distance = std::numeric_limits<double>::infinity();
};

Foot foot_of(const Parts& parts, const Vec2& p) {
  Foot best;
  for (const auto& part : parts) {
    const double parameter = part->nearest(p);
    const Vec2 point = part->at(parameter);
    const double distance = std::hypot(p.x - point.x, p.y - point.y);
    if (distance < best.distance) best = {part.get(), parameter, point, distance};
  }
  return best;
}

double farthest_node(const NacaPlace& place, std::span<const Vec2> nodes) {
  const Parts parts = naca_parts(place);
  double farthest = 0;
  for (const Vec2& p : nodes) farthest = std::max(farthest, foot_of(parts, p).distance);
  return farthest;
}

/// Moved, turned and scaled about its nose, so that the distances get smaller.
NacaPlace one_step(const NacaPlace& place, std::span<const Vec2> nodes) {
  const Parts parts = naca_parts(place);
  Eigen::Matrix4d system = Eigen::Matrix4d::Zero();
  Eigen::Vector4d right = Eigen::Vector4d::Zero();
  for (const Vec2& p : nodes) {
    const Foot foot = foot_of(parts, p);
    const Vec2 tangent = foot.part->direction(foot.parameter);
    const double size = std::hypot(tangent.x, tangent.y);
    if (!(size > 0)) continue;
    const Vec2 normal{-tangent.y / size, tangent.x / size};
    const Vec2 from_nose{(foot.point.x - place.nose.x) / place.chord,
                         (foot.point.y - place.nose.y) / place.chord};
    const Eigen::Vector4d row(normal.x, normal.y, normal.y * from_nose.x - normal.x * from_nose.y,
                              normal.x * from_nose.x + normal.y * from_nose.y);
    system += row * row.transpose();
    right += row * (normal.x * (p.x - foot.point.x) + normal.y * (p.y - foot.point.y));
  }
  const Eigen::Vector4d change = system.ldlt().solve(right);
  // Half a chord at once is no small correction any more.
  if (!change.allFinite() || !(change.norm() < place.chord / 2)) return place;
  NacaPlace next = place;
  next.nose = {place.nose.x + change(0), place.nose.y + change(1)};
  next.chord = place.chord + change(3);
  const double turn = change(2) / place.chord;
  const Vec2 along{place.along.x - turn * place.along.y, place.along.y + turn * place.along.x};
  const double size = std::hypot(along.x, along.y);
  next.along = {along.x / size, along.y / size};
  return next;
}

NacaPlace improved(NacaPlace place, std::span<const Vec2> nodes) {
  double farthest = farthest_node(place, nodes);
  for (int step = 0; step < most_fitting_steps; ++step) {
    const NacaPlace next = one_step(place, nodes);
    const double then = farthest_node(next, nodes);
    if (step > 3 && !(then < farthest * (1 - 1e-6))) break;
    place = next;
    farthest = then;
  }
  return place;
}

std::size_t farthest_from(std::span<const Vec2> nodes, const Vec2& from) {
  std::size_t farthest = 0;
  double most = -1;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const double distance = std::hypot(nodes[i].x - from.x, nodes[i].y - from.y);
    if (distance > most) {
      most = distance;
      farthest = i;
    }
  }
  return farthest;
}

/// Two nodes that are farthest from one another; of a thin profile its two ends.
std::pair<Vec2, Vec2> ends_of(std::span<const Vec2> nodes) {
  Vec2 first = nodes[farthest_from(nodes, nodes[0])];
  Vec2 second = nodes[farthest_from(nodes, first)];
  first = nodes[farthest_from(nodes, second)];
  return {first, second};
}

std::vector<Vec2> some_of(std::span<const Vec2> nodes) {
  std::vector<Vec2> some;
  const std::size_t count = std::min(nodes.size(), most_nodes);
  for (std::size_t i = 0; i < count; ++i) some.push_back(nodes[i * nodes.size() / count]);
  return some;
}

NacaPlace rounded(const NacaPlace& fitted, double step) {
  NacaPlace tried = fitted;
  tried.nose = {rounded_to(fitted.nose.x, step), rounded_to(fitted.nose.y, step)};
  tried.chord = rounded_to(fitted.chord, step);
  // Degrees are about as fine as hundredths of the chord.
  const double angle = std::atan2(fitted.along.y, fitted.along.x) * 180 / std::numbers::pi;
  const double per_degree = step < 0 ? -step * fitted.chord : fitted.chord / step;
  const double degrees = per_degree >= 1e4 ? 1e3 : 1e2;
  tried.along = direction_of_angle(std::round(angle * degrees) / degrees);
  return tried;
}

NacaPlace with_round_numbers(const NacaPlace& fitted, std::span<const Vec2> nodes) {
  const double off = farthest_node(fitted, nodes);
  for (const double step : round_steps(fitted.chord)) {
    const NacaPlace tried = rounded(fitted, step);
    if (tried.chord > 0 && is_as_good(farthest_node(tried, nodes), off, fitted.chord)) return tried;
  }
  return fitted;
}

}  // namespace

std::optional<NacaPlace> fitted_naca(std::span<const Vec2> nodes, double thickness) {
  if (nodes.size() < 5) return std::nullopt;
  const std::vector<Vec2> some = some_of(nodes);
  const auto [first, second] = ends_of(nodes);
  NacaPlace best;
  double least = std::numeric_limits<double>::infinity();
  for (const bool is_sharp : {true, false}) {
    for (const auto& [nose, edge] : {std::pair{first, second}, std::pair{second, first}}) {
      const Vec2 chord{edge.x - nose.x, edge.y - nose.y};
      const double size = std::hypot(chord.x, chord.y);
      if (!(size > 0)) return std::nullopt;
      const NacaPlace start{thickness, is_sharp, nose, size, {chord.x / size, chord.y / size}};
      const NacaPlace place = improved(start, some);
      const double off = farthest_node(place, some);
      if (off < least) {
        least = off;
        best = place;
      }
    }
  }
  return with_round_numbers(best, nodes);
}

NacaPlace with_fitting_edge(std::span<const Vec2> nodes, NacaPlace place) {
  const std::vector<Vec2> some = some_of(nodes);
  place.is_sharp = true;
  const double off_sharp = farthest_node(place, some);
  place.is_sharp = false;
  const double off_blunt = farthest_node(place, some);
  place.is_sharp = off_sharp <= off_blunt;
  return place;
}

}  // namespace tetfarm
