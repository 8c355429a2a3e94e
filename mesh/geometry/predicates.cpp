#include "mesh/geometry/predicates.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "mesh/geometry/double_double.h"
#include "mesh/geometry/expansion.h"
#include "mesh/geometry/integer_sphere.h"
#include "mesh/geometry/sphere_filter.h"

namespace tetfarm {
namespace {

constexpr double eps = std::numeric_limits<double>::epsilon() / 2;  // 2^-53
constexpr double orient2d_bound = (3.0 + 16.0 * eps) * eps;
constexpr double orient3d_bound = (7.0 + 56.0 * eps) * eps;
constexpr double incircle_bound = (10.0 + 96.0 * eps) * eps;

double orient2d_exact(const Vec2& a, const Vec2& b, const Vec2& c) {
  const auto det = exact_difference(a.x, c.x) * exact_difference(b.y, c.y) -
                   exact_difference(a.y, c.y) * exact_difference(b.x, c.x);
  return det.most_significant();
}

double incircle_exact(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  const auto ax = exact_difference(a.x, d.x);
  const auto ay = exact_difference(a.y, d.y);
  const auto bx = exact_difference(b.x, d.x);
  const auto by = exact_difference(b.y, d.y);
  const auto cx = exact_difference(c.x, d.x);
  const auto cy = exact_difference(c.y, d.y);
  const auto term = [](const auto& x, const auto& y, const auto& minor) {
    return (x * x + y * y) * minor;
  };
  const auto det = term(ax, ay, bx * cy - by * cx) + term(bx, by, cx * ay - cy * ax) +
                   term(cx, cy, ax * by - ay * bx);
  return det.most_significant();
}

double orient3d_exact(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const auto bx = exact_difference(b.x, a.x);
  const auto by = exact_difference(b.y, a.y);
  const auto bz = exact_difference(b.z, a.z);
  const auto cx = exact_difference(c.x, a.x);
  const auto cy = exact_difference(c.y, a.y);
  const auto cz = exact_difference(c.z, a.z);
  const auto dx = exact_difference(d.x, a.x);
  const auto dy = exact_difference(d.y, a.y);
  const auto dz = exact_difference(d.z, a.z);
  const auto det = (by * cz - bz * cy) * dx + (bz * cx - bx * cz) * dy + (bx * cy - by * cx) * dz;
  return det.most_significant();
}

struct ExactPoint {
  Expansion<2> x;
  Expansion<2> y;
  Expansion<2> z;
};

/// Determinant of the rows p, q, r.
Expansion<192> exact_minor(const ExactPoint& p, const ExactPoint& q, const ExactPoint& r) {
  return (p.y * q.z - p.z * q.y) * r.x + (p.z * q.x - p.x * q.z) * r.y +
         (p.x * q.y - p.y * q.x) * r.z;
}

/// Only the components in use are touched: the capacity is that of the worst case.
double insphere_exact(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Vec3& e) {
  const auto relative = [&e](const Vec3& p) {
    return ExactPoint{exact_difference(p.x, e.x), exact_difference(p.y, e.y),
                      exact_difference(p.z, e.z)};
  };
  const ExactPoint A = relative(a);
  const ExactPoint B = relative(b);
  const ExactPoint C = relative(c);
  const ExactPoint D = relative(d);
  const auto lift = [](const ExactPoint& p) { return p.x * p.x + p.y * p.y + p.z * p.z; };
  // det of the rows (p, |p|^2) is expanded along the last column; inside is positive for a
  // positive tet a b c d.
  const auto first = exact_minor(B, C, D) * lift(A) - exact_minor(A, C, D) * lift(B);
  const auto second = exact_minor(A, B, D) * lift(C) - exact_minor(A, B, C) * lift(D);
  return (first + second).most_significant();
}

__extension__ using Wide = __int128;

template <std::size_t count>
using GridPoints = std::array<std::array<std::int64_t, 3>, count>;

/// The points as seen from `origin`, as integers of `bits` bits: when all differences are exact and
/// are multiples of 2^-bits of a power of 2 above the largest, as on lattices. What they were
/// multiplied by, a power of 2; 0 when they are on no such grid.
template <std::size_t count>
double scale_to_grid(const std::array<Vec3, count>& points, const Vec3& origin, int bits,
                     GridPoints<count>& result) {
  std::array<Vec3, count> offset;
  double largest = 0;
  for (std::size_t i = 0; i < count; ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      const TwoTerms difference = two_sum(points[i][axis], -origin[axis]);
      if (difference.low != 0) return 0;
      offset[i][axis] = difference.high;
      largest = std::max(largest, std::abs(difference.high));
    }
  }
  const double scale = std::ldexp(1.0, largest > 0 ? bits - 1 - std::ilogb(largest) : 0);
  for (std::size_t i = 0; i < count; ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      const double steps = offset[i][axis] * scale;
      const auto whole = static_cast<std::int64_t>(steps);
      if (static_cast<double>(whole) != steps) return 0;
      result[i][static_cast<std::size_t>(axis)] = whole;
    }
  }
  return scale;
}

/// Determinant of three rows of at most 30 bits.
template <std::size_t count>
Wide minor_of(const GridPoints<count>& v, std::size_t p, std::size_t q, std::size_t r) {
  const auto pair = [&](std::size_t i, std::size_t j) {
    return Wide{v[p][i] * v[q][j] - v[p][j] * v[q][i]};
  };
  return pair(1, 2) * v[r][0] + pair(2, 0) * v[r][1] + pair(0, 1) * v[r][2];
}

/// By integers if the points are on a grid, else by expansions.
double decide_orient3d(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  GridPoints<3> v;
  const double scale = scale_to_grid<3>({b, c, d}, a, 30, v);
  if (scale == 0) return orient3d_exact(a, b, c, d);
  return static_cast<double>(minor_of(v, 0, 1, 2)) / scale / scale / scale;
}

struct DoublePoint {
  DoubleDouble x;
  DoubleDouble y;
  DoubleDouble z;
};

DoubleDouble double_minor(const DoublePoint& p, const DoublePoint& q, const DoublePoint& r) {
  return (p.y * q.z - p.z * q.y) * r.x + (p.z * q.x - p.x * q.z) * r.y +
         (p.x * q.y - p.y * q.x) * r.z;
}

/// The sign by numbers of 106 bits, or 0 when they do not tell.
int insphere_by_double_doubles(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d,
                               const Vec3& e) {
  const auto relative = [&e](const Vec3& p) {
    return DoublePoint{double_difference(p.x, e.x), double_difference(p.y, e.y),
                       double_difference(p.z, e.z)};
  };
  const std::array<DoublePoint, 4> p = {relative(a), relative(b), relative(c), relative(d)};
  std::array<DoubleDouble, 4> lift;
  for (std::size_t i = 0; i < 4; ++i) lift[i] = p[i].x * p[i].x + p[i].y * p[i].y + p[i].z * p[i].z;
  const double det =
      ((double_minor(p[1], p[2], p[3]) * lift[0] - double_minor(p[0], p[2], p[3]) * lift[1]) +
       (double_minor(p[0], p[1], p[3]) * lift[2] - double_minor(p[0], p[1], p[2]) * lift[3]))
          .high;
  // A term passes through 11 operations, so the sum is off by at most 80 · 2^-106 times the
  // permanent, which is at most sqrt(2) / 8 · m^(5/2) (sphere_filter.h): 15 · 2^-106 m^(5/2). The
  // constant keeps underflow from deciding anything.
  const double m = (lift[0].high + lift[1].high) + (lift[2].high + lift[3].high);
  const double bound2 = 0x1p-202 * (m * m * m * m * m) + 1e-280;
  return det * det > bound2 ? (det > 0 ? 1 : -1) : 0;
}

double decide_insphere(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Vec3& e) {
  if (const auto sign = integer_insphere(a, b, c, d, e)) return *sign;
  const int sign = insphere_by_double_doubles(a, b, c, d, e);
  return sign != 0 ? sign : insphere_exact(a, b, c, d, e);
}

}  // namespace

double orient2d(const Vec2& a, const Vec2& b, const Vec2& c) {
  const double left = (a.x - c.x) * (b.y - c.y);
  const double right = (a.y - c.y) * (b.x - c.x);
  const double det = left - right;
  const double bound = orient2d_bound * (std::abs(left) + std::abs(right));
  if (det > bound || -det > bound) return det;
  return orient2d_exact(a, b, c);
}

double incircle(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  const double ax = a.x - d.x;
  const double ay = a.y - d.y;
  const double bx = b.x - d.x;
  const double by = b.y - d.y;
  const double cx = c.x - d.x;
  const double cy = c.y - d.y;
  const double a_lift = ax * ax + ay * ay;
  const double b_lift = bx * bx + by * by;
  const double c_lift = cx * cx + cy * cy;
  const double det =
      a_lift * (bx * cy - by * cx) + b_lift * (cx * ay - cy * ax) + c_lift * (ax * by - ay * bx);
  const double permanent = (std::abs(bx * cy) + std::abs(by * cx)) * a_lift +
                           (std::abs(cx * ay) + std::abs(cy * ax)) * b_lift +
                           (std::abs(ax * by) + std::abs(ay * bx)) * c_lift;
  const double bound = incircle_bound * permanent;
  if (det > bound || -det > bound) return det;
  return incircle_exact(a, b, c, d);
}

double orient3d(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const Vec3 u = b - a;
  const Vec3 v = c - a;
  const Vec3 w = d - a;
  const double vy_wz = v.y * w.z;
  const double vz_wy = v.z * w.y;
  const double vz_wx = v.z * w.x;
  const double vx_wz = v.x * w.z;
  const double vx_wy = v.x * w.y;
  const double vy_wx = v.y * w.x;
  const double det = u.x * (vy_wz - vz_wy) + u.y * (vz_wx - vx_wz) + u.z * (vx_wy - vy_wx);
  const double permanent = (std::abs(vy_wz) + std::abs(vz_wy)) * std::abs(u.x) +
                           (std::abs(vz_wx) + std::abs(vx_wz)) * std::abs(u.y) +
                           (std::abs(vx_wy) + std::abs(vy_wx)) * std::abs(u.z);
  const double bound = orient3d_bound * permanent;
  if (det > bound || -det > bound) return det;
  return decide_orient3d(a, b, c, d);
}

double insphere(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Vec3& e) {
  const FilteredSphere filtered = filtered_insphere(a, b, c, d, e);
  if (filtered.is_certain) return filtered.det;
  return decide_insphere(a, b, c, d, e);
}

bool in_perturbed_sphere(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Vec3& e,
                         const std::int32_t (&ids)[5]) {
  const FilteredSphere filtered = filtered_insphere(a, b, c, d, e);
  if (filtered.is_certain) return filtered.det > 0;
  return in_perturbed_sphere_exactly(a, b, c, d, e, ids);
}

bool in_perturbed_sphere_exactly(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d,
                                 const Vec3& e, const std::int32_t (&ids)[5]) {
  const double side = decide_insphere(a, b, c, d, e);
  if (side != 0) return side > 0;
  std::array<int, 5> order = {0, 1, 2, 3, 4};
  std::sort(order.begin(), order.end(), [&ids](int i, int j) { return ids[i] > ids[j]; });
  // The leading coefficients of the perturbation: two of them decide, see the paper.
  for (int k = 0; k < 3; ++k) {
    double sign = 0;
    switch (order[static_cast<std::size_t>(k)]) {
      case 4:
        return false;
      case 3:
        sign = orient3d(a, b, c, e);
        break;
      case 2:
        sign = orient3d(a, b, e, d);
        break;
      case 1:
        sign = orient3d(a, e, c, d);
        break;
      default:
        sign = orient3d(e, b, c, d);
        break;
    }
    if (sign != 0) return sign > 0;
  }
  return false;
}

}  // namespace tetfarm
