/// Points with rational coordinates: where edges and planes through points of doubles meet is among
/// them, without rounding.
///
/// Source: GMP's rational numbers; signs are first looked for in doubles, with a bound on their
/// error, as in J. R. Shewchuk, "Adaptive precision floating-point arithmetic and fast robust
/// geometric predicates" (1997). Lengths in the unit of the input.
#pragma once

#include <gmpxx.h>

#include <array>
#include <cstdint>
#include <map>
#include <vector>

#include "mesh/core/vec3.h"

namespace tetfarm {

struct ExactPoint {
  std::array<mpq_class, 3> at;
  Vec3 near;  ///< the coordinates, each rounded by less than its last bit
};

/// @pre finite coordinates.
ExactPoint exact_point(const Vec3& p);

/// A box that the point is in, though it is near its coordinates only.
Box3 box_round(const ExactPoint& p);

/// p + share (q - p).
ExactPoint point_between(const ExactPoint& p, const ExactPoint& q, const mpq_class& share);

/// Where the line pq meets the plane abc. @pre p and q are not at the same distance from it.
ExactPoint plane_crossing(const Vec3& p, const Vec3& q, const std::array<Vec3, 3>& abc);

/// Twice the area of abc as seen along an axis, positive when anticlockwise: of the coordinates
/// axis + 1 and axis + 2, modulo 3.
mpq_class seen_area(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c, int axis);

/// Its sign. Cost: that of doubles where these can tell.
int seen_turn(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c, int axis);

/// Points under numbers, equal ones under one.
class ExactPoints {
 public:
  /// The number that the point has, or the next. Cost: O(log n).
  std::int32_t add(ExactPoint point);

  std::int32_t size() const { return static_cast<std::int32_t>(points_.size()); }
  const ExactPoint& operator[](std::int32_t number) const {
    return points_[static_cast<std::size_t>(number)];
  }

 private:
  std::vector<ExactPoint> points_;
  std::map<std::array<double, 3>, std::vector<std::int32_t>> numbers_;  // by what is near them
};

}  // namespace tetfarm
