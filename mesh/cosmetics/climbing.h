/// Climbing: moves the node of a star so that the smallest of a measure over its tets gets larger.
///
/// Source: L. A. Freitag, M. Jones and P. Plassmann, "A parallel algorithm for mesh smoothing"
/// (1999): along the shortest vector in the hull of the gradients of the tets that are nearly the
/// worst.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <span>
#include <vector>

#include "mesh/core/vec3.h"

namespace tetfarm::cosmetics {

/// Three corners of a face that a node sees, such that (face, node) is a positive tet.
using StarFace = std::array<Vec3, 3>;
using Star = std::vector<StarFace>;

/// A place for a node, and the smallest measure of its star there.
struct Place {
  Vec3 point;
  double worst = 0;
};

/// What is to become larger: a number for a face of the star and a place of its node, smooth, at
/// most about 1.
template <typename T>
concept Measure = requires(const T& measure, const StarFace& face, const Vec3& p) {
  { measure(face, p) } -> std::convertible_to<double>;
};

/// One that tells the smaller of two faces faster than one after the other.
template <typename T>
concept MeasureOfTwo = requires(const T& measure, const StarFace& face, const Vec3& p) {
  { measure(face, face, p) } -> std::convertible_to<double>;
};

/// The shortest vector in the convex hull (Gilbert's iteration), close enough for a direction.
Vec3 shortest_in_hull(std::span<const Vec3> vectors);

/// The shortest distance from p to a corner of the star, squared.
double shortest_distance2(const Star& star, const Vec3& p);

/// The smallest measure of the star with its node at p; any value below `least` once it is below.
template <Measure M>
double worst_at(const Star& star, const Vec3& p, double least, const M& measure) {
  double worst = HUGE_VAL;
  std::size_t i = 0;
  if constexpr (MeasureOfTwo<M>) {
    for (; i + 1 < star.size() && !(worst < least); i += 2) {
      worst = std::min<double>(worst, measure(star[i], star[i + 1], p));
    }
  }
  for (; i < star.size() && !(worst < least); ++i) {
    worst = std::min<double>(worst, measure(star[i], p));
  }
  return worst;
}

template <Measure M>
Vec3 gradient(const StarFace& face, const Vec3& p, double here, double step, const M& measure) {
  Vec3 slope;
  for (int axis = 0; axis < 3; ++axis) {
    Vec3 q = p;
    q[axis] += step;
    slope[axis] = (measure(face, q) - here) / step;
  }
  return slope;
}

/// A direction in which all tets that are nearly the worst get better; zero when there is none.
template <Measure M>
Vec3 direction_up(const Star& star, const Vec3& p, double worst, double length, const M& measure) {
  constexpr std::size_t most_active = 12;
  const double below = worst + 0.1 * std::max(std::fabs(worst), 0.05);
  std::array<Vec3, most_active> gradients;
  std::size_t active = 0;
  for (const StarFace& face : star) {
    const double here = measure(face, p);
    if (here > below) continue;
    gradients[active++] = gradient(face, p, here, 1e-6 * length, measure);
    if (active == most_active) break;
  }
  return shortest_in_hull(std::span(gradients.data(), active));
}

/// Climbs from `start` (which may see faces from behind) until the worst is `enough`, or no more
/// progress is made.
/// Cost: at most some 60 measures a face.
template <Measure M>
Place climb(const Star& star, const Vec3& start, double enough, const M& measure) {
  constexpr int most_climbs = 8;
  constexpr int most_halvings = 5;
  Place place{start, worst_at(star, start, -HUGE_VAL, measure)};
  double length = std::sqrt(shortest_distance2(star, start));
  if (!(length > 0)) return place;
  double step = 0.25 * length;
  for (int i = 0; i < most_climbs && place.worst < enough; ++i) {
    const Vec3 up = normalized(direction_up(star, place.point, place.worst, length, measure));
    if (!(norm2(up) > 0)) break;
    const double before = place.worst;
    for (int halving = 0; halving < most_halvings; ++halving) {
      const Vec3 p = place.point + step * up;
      const double worst = worst_at(star, p, before, measure);
      if (worst > before) {
        place = {p, worst};
        break;
      }
      step *= 0.5;
    }
    if (place.worst <= before + 1e-3 * std::fabs(before)) break;
    step *= 1.5;
  }
  return place;
}

}  // namespace tetfarm::cosmetics
