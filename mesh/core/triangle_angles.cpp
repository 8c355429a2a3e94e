#include "mesh/core/triangle_angles.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tetfarm {
namespace {

/// Whether each angle is clearly larger than a needle's, without an arc tangent: one cross product
/// over the dot product at each corner.
bool is_clearly_no_needle(const Vec3& a, const Vec3& b, const Vec3& c) {
  constexpr double limit = 0.268;  // tan 15° is 0.26795
  const Vec3 ab = b - a;
  const Vec3 bc = c - b;
  const Vec3 ca = a - c;
  const double largest = std::max({-dot(ab, ca), -dot(bc, ab), -dot(ca, bc)});
  return norm2(cross(ab, ca)) > limit * limit * largest * largest;
}

}  // namespace

double smallest_angle_deg(const Vec3& a, const Vec3& b, const Vec3& c) {
  const auto angle = [](const Vec3& u, const Vec3& v) {
    return std::atan2(norm(cross(u, v)), dot(u, v)) * 180 / std::numbers::pi;
  };
  return std::min({angle(b - a, c - a), angle(c - b, a - b), angle(a - c, b - c)});
}

std::int64_t needle_count(const std::vector<Vec3>& vertices,
                          const std::vector<Triangle>& triangles) {
  const auto at = [&vertices](std::int32_t v) { return vertices[static_cast<std::size_t>(v)]; };
  return std::count_if(triangles.begin(), triangles.end(), [&at](const Triangle& t) {
    return !is_clearly_no_needle(at(t[0]), at(t[1]), at(t[2])) &&
           smallest_angle_deg(at(t[0]), at(t[1]), at(t[2])) < needle_deg;
  });
}

}  // namespace tetfarm
