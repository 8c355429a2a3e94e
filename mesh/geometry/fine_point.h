/// Points with some 106 bits a coordinate, for places that must lie on an edge or a face far more
/// exactly than doubles can say, and their exact predicates.
///
/// Source: as predicates.h; the filters are its static bound on differences rounded once, then
/// DoubleDouble, then expansions. Every input is taken as the exact sum of its two doubles. Units
/// and range of coordinates as there. Cost: some 100 flops when the first filter decides, up to
/// 100 µs when only expansions do.
#pragma once

#include "mesh/core/vec3.h"
#include "mesh/geometry/double_double.h"

namespace tetfarm {

/// high + low, where high is the double nearest to the sum.
struct FinePoint {
  Vec3 high;
  Vec3 low;

  DoubleDouble operator[](int axis) const { return {high[axis], low[axis]}; }
  bool is_plain() const { return low == Vec3{}; }
};

inline FinePoint fine(const Vec3& p) { return {p, {}}; }

struct FineVec3 {
  DoubleDouble x;
  DoubleDouble y;
  DoubleDouble z;

  Vec3 rounded() const { return {x.high, y.high, z.high}; }
};
inline FineVec3 fine_vector(const Vec3& v) { return {{v.x, 0}, {v.y, 0}, {v.z, 0}}; }
inline FineVec3 operator*(const DoubleDouble& s, const FineVec3& v) {
  return {s * v.x, s * v.y, s * v.z};
}
/// b - a to the last of 106 bits.
FineVec3 difference(const FinePoint& a, const FinePoint& b);
FineVec3 cross(const FineVec3& a, const FineVec3& b);
DoubleDouble dot(const FineVec3& a, const FineVec3& b);

/// a + share (b - a).
FinePoint between(const FinePoint& a, const FinePoint& b, const DoubleDouble& share);
FinePoint moved(const FinePoint& p, const FineVec3& step);

/// As orient3d of doubles: the sign is exact, the size right to rounding.
double orient3d(const FinePoint& a, const FinePoint& b, const FinePoint& c, const FinePoint& d);
/// The same to some 100 bits of its permanent: the sign is not exact.
DoubleDouble fine_orient3d(const FinePoint& a, const FinePoint& b, const FinePoint& c,
                           const FinePoint& d);
/// orient2d of the points as seen along an axis: only the sign is exact.
double orient2d_along(int axis, const FinePoint& a, const FinePoint& b, const FinePoint& c);

}  // namespace tetfarm
