#include "mesh/geometry/fine_point.h"

#include <cmath>

#include "base/check.h"
#include "mesh/geometry/predicates.h"

namespace tetfarm {
namespace {

/// Without error: differences of both parts, merged.
Expansion<4> fine_difference(const DoubleDouble& a, const DoubleDouble& b) {
  return exact_difference(a.high, b.high) + exact_difference(a.low, b.low);
}

double orient3d_exact(const FinePoint& a, const FinePoint& b, const FinePoint& c,
                      const FinePoint& d) {
  const auto bx = fine_difference(b[0], a[0]);
  const auto by = fine_difference(b[1], a[1]);
  const auto bz = fine_difference(b[2], a[2]);
  const auto cx = fine_difference(c[0], a[0]);
  const auto cy = fine_difference(c[1], a[1]);
  const auto cz = fine_difference(c[2], a[2]);
  const auto dx = fine_difference(d[0], a[0]);
  const auto dy = fine_difference(d[1], a[1]);
  const auto dz = fine_difference(d[2], a[2]);
  const auto det = (by * cz - bz * cy) * dx + (bz * cx - bx * cz) * dy + (bx * cy - by * cx) * dz;
  return det.most_significant();
}

/// Sum of the sizes of the determinant's terms.
double permanent(const Vec3& u, const Vec3& v, const Vec3& w) {
  return (std::abs(v.y * w.z) + std::abs(v.z * w.y)) * std::abs(u.x) +
         (std::abs(v.z * w.x) + std::abs(v.x * w.z)) * std::abs(u.y) +
         (std::abs(v.x * w.y) + std::abs(v.y * w.x)) * std::abs(u.z);
}

/// Each difference is rounded once, as in plain orient3d, and its bound holds; one more unit pays
/// for the last bits of the 106.
constexpr double first_bound = 0x1p-50;
/// A term passes through 3 differences, 2 products and 3 sums, each off by at most 7 · 2^-106.
constexpr double second_bound = 0x1p-99;

}  // namespace

FineVec3 difference(const FinePoint& a, const FinePoint& b) {
  return {b[0] - a[0], b[1] - a[1], b[2] - a[2]};
}

FineVec3 cross(const FineVec3& a, const FineVec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

DoubleDouble dot(const FineVec3& a, const FineVec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

FinePoint between(const FinePoint& a, const FinePoint& b, const DoubleDouble& share) {
  FinePoint p;
  for (int axis = 0; axis < 3; ++axis) {
    const DoubleDouble x = a[axis] + share * (b[axis] - a[axis]);
    p.high[axis] = x.high;
    p.low[axis] = x.low;
  }
  return p;
}

FinePoint moved(const FinePoint& p, const FineVec3& step) {
  const DoubleDouble x = p[0] + step.x, y = p[1] + step.y, z = p[2] + step.z;
  return {{x.high, y.high, z.high}, {x.low, y.low, z.low}};
}

DoubleDouble fine_orient3d(const FinePoint& a, const FinePoint& b, const FinePoint& c,
                           const FinePoint& d) {
  return dot(difference(a, b), cross(difference(a, c), difference(a, d)));
}

double orient3d(const FinePoint& a, const FinePoint& b, const FinePoint& c, const FinePoint& d) {
  const FineVec3 fine_u = difference(a, b), fine_v = difference(a, c), fine_w = difference(a, d);
  const Vec3 u = fine_u.rounded(), v = fine_v.rounded(), w = fine_w.rounded();
  const double size = permanent(u, v, w);
  const double rough = dot(u, cross(v, w));
  if (std::abs(rough) > first_bound * size) return rough;
  const double better = dot(fine_u, cross(fine_v, fine_w)).high;
  if (std::abs(better) > second_bound * size) return better;
  return orient3d_exact(a, b, c, d);
}

double orient2d_along(int axis, const FinePoint& a, const FinePoint& b, const FinePoint& c) {
  TF_CHECK(axis >= 0 && axis < 3);
  const int i = (axis + 1) % 3, j = (axis + 2) % 3;
  const auto det = fine_difference(a[i], c[i]) * fine_difference(b[j], c[j]) -
                   fine_difference(a[j], c[j]) * fine_difference(b[i], c[i]);
  return det.most_significant();
}

}  // namespace tetfarm
