#include "mesh/geometry/triangle_distance.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tetfarm {

double distance2_to_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 normal = cross(b - a, c - a);
  const double area2 = norm2(normal);
  bool is_above = area2 > 0;
  double nearest = HUGE_VAL;
  for (const auto& [u, v] : {std::pair{a, b}, std::pair{b, c}, std::pair{c, a}}) {
    const Vec3 along = v - u;
    const double length2 = norm2(along);
    const double t = length2 > 0 ? std::clamp(dot(p - u, along) / length2, 0.0, 1.0) : 0.0;
    nearest = std::min(nearest, norm2(p - (u + t * along)));
    if (dot(cross(normal, along), p - u) < 0) is_above = false;
  }
  if (!is_above) return nearest;
  const double height = dot(normal, p - a);
  return height * height / area2;
}

bool is_nearer_to_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c,
                           double distance) {
  const Vec3 normal = cross(b - a, c - a);
  const double height = dot(normal, p - a);
  const double distance2 = distance * distance;
  // Most triangles are told by their plane alone.
  if (height * height > distance2 * norm2(normal)) return false;
  return distance2_to_triangle(p, a, b, c) < distance2;
}

}  // namespace tetfarm
