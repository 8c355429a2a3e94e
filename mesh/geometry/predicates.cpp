#include "mesh/geometry/predicates.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "mesh/geometry/expansion.h"

namespace tetfarm {
namespace {

constexpr double eps = std::numeric_limits<double>::epsilon() / 2;  // 2^-53
constexpr double orient2d_bound = (3.0 + 16.0 * eps) * eps;
constexpr double orient3d_bound = (7.0 + 56.0 * eps) * eps;
constexpr double incircle_bound = (10.0 + 96.0 * eps) * eps;
constexpr double insphere_bound = (16.0 + 224.0 * eps) * eps;

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
  return orient3d_exact(a, b, c, d);
}

double insphere(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Vec3& e) {
  const Vec3 A = a - e;
  const Vec3 B = b - e;
  const Vec3 C = c - e;
  const Vec3 D = d - e;
  const double ab = A.x * B.y - B.x * A.y;
  const double bc = B.x * C.y - C.x * B.y;
  const double cd = C.x * D.y - D.x * C.y;
  const double da = D.x * A.y - A.x * D.y;
  const double ac = A.x * C.y - C.x * A.y;
  const double bd = B.x * D.y - D.x * B.y;
  const double abc = A.z * bc - B.z * ac + C.z * ab;
  const double bcd = B.z * cd - C.z * bd + D.z * bc;
  const double cda = C.z * da + D.z * ac + A.z * cd;
  const double dab = D.z * ab + A.z * bd + B.z * da;
  const double a_lift = norm2(A);
  const double b_lift = norm2(B);
  const double c_lift = norm2(C);
  const double d_lift = norm2(D);
  const double det = (a_lift * bcd - b_lift * cda) + (c_lift * dab - d_lift * abc);

  // A cheap bound first: every product of the permanent is at most X * Y * Z * lift.
  const auto largest = [](double p, double q, double r, double s) {
    return std::max(std::max(std::abs(p), std::abs(q)), std::max(std::abs(r), std::abs(s)));
  };
  const double x = largest(A.x, B.x, C.x, D.x);
  const double y = largest(A.y, B.y, C.y, D.y);
  const double z = largest(A.z, B.z, C.z, D.z);
  const double lift_sum = (a_lift + b_lift) + (c_lift + d_lift);
  // Six products of each minor, each at most x y z; the sum of the four lifts covers all terms.
  const double bound = insphere_bound * 1.0000001 * (6.0 * x * y * z * lift_sum);
  if (det > bound || -det > bound) return det;
  return insphere_exact(a, b, c, d, e);
}

bool in_perturbed_sphere(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Vec3& e,
                         const std::int32_t (&ids)[5]) {
  const double side = insphere(a, b, c, d, e);
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
