#include "mesh/geometry/triangle_distance.h"

#include <algorithm>

namespace tetfarm {
namespace {

double distance2_to_segment(const Vec3& p, const Vec3& u, const Vec3& v) {
  const Vec3 along = v - u;
  const double length2 = norm2(along);
  const double t = length2 > 0 ? std::clamp(dot(p - u, along) / length2, 0.0, 1.0) : 0.0;
  return norm2(p - (u + t * along));
}

}  // namespace

double distance2_to_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 normal = cross(b - a, c - a);
  const double area2 = norm2(normal);
  const auto is_inside_of = [&](const Vec3& u, const Vec3& v) {
    return !(dot(cross(normal, v - u), p - u) < 0);
  };
  if (area2 > 0 && is_inside_of(a, b) && is_inside_of(b, c) && is_inside_of(c, a)) {
    const double height = dot(normal, p - a);
    return height * height / area2;
  }
  return std::min({distance2_to_segment(p, a, b), distance2_to_segment(p, b, c),
                   distance2_to_segment(p, c, a)});
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
