#include "mesh/decompose/rim_angles.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/array_index.h"

namespace tetfarm {
namespace {

std::int32_t node_opposite(const Triangle& triangle, const RimEdge& edge) {
  for (const std::int32_t v : triangle) {
    if (v != edge.from && v != edge.to) return v;
  }
  return triangle[0];
}

}  // namespace

Vec3 direction_into(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 along = normalized(b - a);
  return normalized((c - a) - dot(c - a, along) * along);
}

RimCorner rim_corner(const Subdomain& subdomain, const SurfaceTopology& topology,
                     const RimEdge& edge) {
  const auto point = [&](std::int32_t v) { return subdomain.vertices[at(v)]; };
  const Vec3 a = point(edge.from);
  const Vec3 b = point(edge.to);
  const auto opposite = [&](std::int32_t triangle) {
    return point(node_opposite(subdomain.triangles[at(triangle)], edge));
  };
  RimCorner corner;
  corner.along = normalized(b - a);
  corner.into_left = direction_into(a, b, opposite(edge.left_triangle));
  corner.into_right = direction_into(a, b, opposite(edge.right_triangle));
  corner.left_inward = -normalized(topology.normal[at(edge.left_triangle)]);
  corner.right_inward = -normalized(topology.normal[at(edge.right_triangle)]);
  corner.is_convex = dot(corner.left_inward, corner.into_right) > 0;
  return corner;
}

Vec3 bisector(const RimCorner& corner) {
  const Vec3 between = corner.into_left + corner.into_right;
  const Vec3 inward = corner.left_inward + corner.right_inward;
  if (norm2(inward) > norm2(between)) return normalized(inward);
  return corner.is_convex ? normalized(between) : -normalized(between);
}

double cosine_at_bisector(const RimCorner& corner) {
  return cosine_to_sides(corner, bisector(corner));
}

double cosine_to_sides(const RimCorner& corner, const Vec3& into_cut) {
  const auto turns_from_to = [&](const Vec3& a, const Vec3& b) {
    // Positive when b lies less than 180 degrees from a, turning from the left side into the
    // material.
    const double ax = dot(a, corner.into_left);
    const double ay = dot(a, corner.left_inward);
    const double bx = dot(b, corner.into_left);
    const double by = dot(b, corner.left_inward);
    return ax * by - ay * bx > 0;
  };
  const bool is_after_left = turns_from_to(corner.into_left, into_cut);
  const bool is_before_right = turns_from_to(into_cut, corner.into_right);
  const bool is_inside =
      corner.is_convex ? is_after_left && is_before_right : is_after_left || is_before_right;
  if (!is_inside) return 1;
  return std::max(dot(into_cut, corner.into_left), dot(into_cut, corner.into_right));
}

double cosine_of_degrees(double degrees) {
  const double x = degrees * std::numbers::pi / 180;
  double term = 1;
  double sum = 1;
  for (int k = 1; k < 14; ++k) {
    term *= -x * x / ((2.0 * k - 1) * (2.0 * k));
    sum += term;
  }
  return sum;
}

}  // namespace tetfarm
