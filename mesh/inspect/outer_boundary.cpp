#include "mesh/inspect/outer_boundary.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>

#include "base/check.h"
#include "base/error.h"
#include "mesh/core/complaints.h"
#include "mesh/shapes/box_and_sphere.h"

namespace tetfarm {
namespace {

// A side of the box is at least this many default spacings long, and so is the sphere's diameter.
constexpr double least_spacings = 6;
// The edge of a regular icosahedron's face, seen from the centre, in radians.
constexpr double icosahedron_arc = 1.1071487177940904;

// The edge of a regular octahedron's face, the same.
constexpr double quarter_turn = 1.5707963267948966;

struct Body {
  Box3 box;
  double longest_edge = 0;
};

Body measure(const SurfaceMesh& surface) {
  Body body;
  for (const Triangle& t : surface.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3& a = surface.vertices[static_cast<std::size_t>(t[i])];
      const Vec3& b = surface.vertices[static_cast<std::size_t>(t[(i + 1) % 3])];
      body.box.add(a);
      body.longest_edge = std::max(body.longest_edge, distance(a, b));
    }
  }
  return body;
}

void check_numbers(const SurfaceMesh& body, const OuterBoundary& outer, double growth) {
  if (body.triangles.empty())
    throw UsageError("there is no body to put a boundary around", "domain.outer");
  if (!std::isfinite(outer.factor) || outer.factor <= 1) {
    throw UsageError("the factor must be greater than 1, or the boundary touches the body; it is " +
                         text_of(outer.factor),
                     "domain.factor");
  }
  if (!std::isfinite(outer.spacing) || outer.spacing < 0) {
    throw UsageError(
        "the spacing must be positive, or 0 for the default; it is " + text_of(outer.spacing),
        "domain.spacing");
  }
  if (!std::isfinite(outer.default_spacing) || outer.default_spacing < 0) {
    throw UsageError(
        "the spacing must be positive, or 0 for none; it is " + text_of(outer.default_spacing),
        "spacing.default");
  }
  if (!std::isfinite(growth) || growth < 0) {
    throw UsageError("the growth must not be negative; it is " + text_of(growth), "spacing.growth");
  }
}

/// The spacing of those that somebody asked for; 0: it follows from the body.
double asked_spacing(const OuterBoundary& outer, double by_growth) {
  if (outer.spacing > 0) return outer.spacing;
  return outer.default_spacing > 0 && outer.default_spacing < by_growth ? outer.default_spacing : 0;
}

/// How many parts to divide `length` into, when `triangles_at_1` · parts² triangles come of it.
int parts_of(double length, double triangles_at_1, int least, const OuterBoundary& outer,
             double by_growth) {
  const auto parts_with = [&](double triangles) {
    return std::floor(std::sqrt(triangles / triangles_at_1));
  };
  const double asked = asked_spacing(outer, by_growth);
  const double parts = std::ceil(length / (asked > 0 ? asked : by_growth));
  const double most = parts_with(asked > 0 && !outer.is_sketch ? most_triangles : few_triangles);
  if (asked > 0 && !outer.is_sketch && parts > most) {
    throw UsageError("a spacing of " + text_of(asked) + " would make more than " +
                         std::to_string(static_cast<int>(most_triangles)) +
                         " triangles on the outer boundary; the smallest that does not is " +
                         text_of(length / most),
                     outer.spacing > 0 ? "domain.spacing" : "spacing.default");
  }
  return static_cast<int>(std::clamp(parts, static_cast<double>(least), most));
}

void check_room(bool has_room, const OuterBoundary& outer) {
  if (has_room) return;
  throw UsageError("with a factor of " + text_of(outer.factor) +
                       " the boundary touches the body; give a larger factor or a finer spacing",
                   "domain.factor");
}

struct Cube {
  Box3 box;
  int parts = 0;  ///< that each edge is in
};

Cube cube_round(const Body& body, const OuterBoundary& outer, double growth) {
  const Vec3 size = body.box.size();
  const double body_half = 0.5 * std::max({size.x, size.y, size.z});
  const double half = outer.factor * body_half;
  const double side = 2 * half;
  const double spacing =
      std::min(body.longest_edge + growth * (half - body_half), side / least_spacings);
  const Vec3 centre = body.box.centre();
  const Box3 box{centre - Vec3{half, half, half}, centre + Vec3{half, half, half}};
  for (int axis = 0; axis < 3; ++axis) {
    check_room(box.low[axis] < body.box.low[axis] && box.high[axis] > body.box.high[axis], outer);
  }
  return {box, parts_of(side, 12, 2, outer, spacing)};
}

SurfaceMesh make_box(const Body& body, const OuterBoundary& outer, double growth) {
  const Cube cube = cube_round(body, outer, growth);
  return box_surface(cube.box, cube.parts);
}

/// The sphere round a body: where, how large, and how long edges may be.
struct Sphere {
  Vec3 centre;
  double half_diagonal = 0;  ///< of the body
  double radius = 0;
  double spacing = 0;
};

Sphere sphere_round(const Body& body, const OuterBoundary& outer, double growth) {
  Sphere sphere{body.box.centre(), 0.5 * norm(body.box.size()), 0, 0};
  sphere.radius = outer.factor * sphere.half_diagonal;
  sphere.spacing = std::min(body.longest_edge + growth * (sphere.radius - sphere.half_diagonal),
                            2 * sphere.radius / least_spacings);
  return sphere;
}

/// Its triangles lie inside the true sphere.
void check_room_in(const SurfaceMesh& triangles, const Sphere& sphere, const OuterBoundary& outer) {
  check_room(nearest_plane(triangles, sphere.centre) > sphere.half_diagonal * (1 + 1e-9), outer);
}

SurfaceMesh make_sphere(const Body& body, const OuterBoundary& outer, double growth) {
  const Sphere sphere = sphere_round(body, outer, growth);
  SurfaceMesh triangles =
      sphere_surface(sphere.centre, sphere.radius,
                     parts_of(icosahedron_arc * sphere.radius, 20, 2, outer, sphere.spacing));
  check_room_in(triangles, sphere, outer);
  return triangles;
}

/// With its mirror image behind the plane.
Body mirrored(Body body, const AxisPlane& plane) {
  const double reach = std::max(std::fabs(body.box.low[plane.axis] - plane.height),
                                std::fabs(body.box.high[plane.axis] - plane.height));
  body.box.low[plane.axis] = plane.height - reach;
  body.box.high[plane.axis] = plane.height + reach;
  return body;
}

SurfaceMesh make_half_box(const Body& both, const OuterBoundary& outer, double growth,
                          const AxisPlane& plane, int side) {
  const Cube cube = cube_round(both, outer, growth);
  Box3 half = cube.box;
  (side > 0 ? half.low : half.high)[plane.axis] = plane.height;
  std::array<int, 3> parts = {cube.parts, cube.parts, cube.parts};
  parts.at(static_cast<std::size_t>(plane.axis)) = (cube.parts + 1) / 2;
  return open_box_surface(half, parts, {plane.axis, side > 0 ? 0 : 1});
}

SurfaceMesh make_half_sphere(const Body& both, const OuterBoundary& outer, double growth,
                             const AxisPlane& plane, int side) {
  Sphere sphere = sphere_round(both, outer, growth);
  sphere.centre[plane.axis] = plane.height;
  SurfaceMesh triangles = half_sphere_surface(
      sphere.centre, sphere.radius,
      parts_of(quarter_turn * sphere.radius, 4, 2, outer, sphere.spacing), plane.axis, side);
  check_room_in(triangles, sphere, outer);
  return triangles;
}

}  // namespace

SurfaceMesh add_outer_boundary(const SurfaceMesh& body, const OuterBoundary& outer, double growth) {
  if (outer.kind == OuterBoundary::Kind::none) return body;
  check_numbers(body, outer, growth);
  const bool is_box = outer.kind == OuterBoundary::Kind::box;
  const Body measured = measure(body);
  const SurfaceMesh boundary =
      is_box ? make_box(measured, outer, growth) : make_sphere(measured, outer, growth);

  SurfaceMesh result = body;
  // With sides, the body's triangles already tell the outside, region 1, from the rest.
  if (result.sides.empty()) {
    for (Triangle& t : result.triangles) std::swap(t[1], t[2]);
  }
  if (result.patch_of_triangle.empty()) {
    result.patch_of_triangle.assign(result.triangles.size(), 0);
    result.patch_names = {"surface"};
  }
  const auto offset = static_cast<std::int32_t>(result.vertices.size());
  result.vertices.insert(result.vertices.end(), boundary.vertices.begin(), boundary.vertices.end());
  for (const auto& [a, b, c] : boundary.triangles) {
    result.triangles.push_back({a + offset, b + offset, c + offset});
  }
  if (!result.sides.empty()) result.sides.resize(result.triangles.size(), Sides{1, 0});
  result.patch_of_triangle.resize(result.triangles.size(),
                                  static_cast<std::int32_t>(result.patch_names.size()));
  result.patch_names.emplace_back(is_box ? "outer_box" : "outer_sphere");
  TF_CHECK(result.patch_of_triangle.size() == result.triangles.size());
  return result;
}

HalfOuterBoundary half_outer_boundary(const SurfaceMesh& body, const OuterBoundary& outer,
                                      double growth, const AxisPlane& plane, int side) {
  TF_CHECK(outer.kind != OuterBoundary::Kind::none);
  check_numbers(body, outer, growth);
  const Body both = mirrored(measure(body), plane);
  if (outer.kind == OuterBoundary::Kind::box) {
    return {make_half_box(both, outer, growth, plane, side), "outer_box"};
  }
  return {make_half_sphere(both, outer, growth, plane, side), "outer_sphere"};
}

}  // namespace tetfarm
