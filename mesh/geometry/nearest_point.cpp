#include "mesh/geometry/nearest_point.h"

#include <algorithm>

namespace tetfarm {
namespace {

/// A triangle lower than 1e-7 of its edges has a normal of rounding, and is its edges.
constexpr double least_height_share2 = 1e-14;

}  // namespace

Vec3 nearest_on_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 along = b - a;
  const double length2 = norm2(along);
  if (!(length2 > 0)) return a;
  return a + std::clamp(dot(p - a, along) / length2, 0.0, 1.0) * along;
}

Vec3 nearest_on_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 normal = cross(b - a, c - a);
  const double longest2 = std::max(norm2(b - a), norm2(c - a));
  if (norm2(normal) > least_height_share2 * longest2 * longest2) {
    // The foot on the plane, by the areas that it makes with the edges.
    const double at_a = dot(cross(b - p, c - p), normal);
    const double at_b = dot(cross(c - p, a - p), normal);
    const double at_c = dot(cross(a - p, b - p), normal);
    if (at_a >= 0 && at_b >= 0 && at_c >= 0) {
      const double sum = at_a + at_b + at_c;
      return (at_a / sum) * a + (at_b / sum) * b + (at_c / sum) * c;
    }
  }
  Vec3 best = nearest_on_segment(p, a, b);
  for (const Vec3& other : {nearest_on_segment(p, b, c), nearest_on_segment(p, c, a)}) {
    if (norm2(other - p) < norm2(best - p)) best = other;
  }
  return best;
}

}  // namespace tetfarm
