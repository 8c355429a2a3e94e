#include "mesh/half_body/close_half_body.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <utility>

#include "base/array_index.h"
#include "base/check.h"
#include "base/error.h"
#include "mesh/core/complaints.h"
#include "mesh/half_body/nested_loops.h"
#include "mesh/planar/planar_mesh.h"

namespace tetfarm {
namespace {

/// The plane's own coordinates: anticlockwise is anticlockwise seen along the negative axis.
struct PlaneAxes {
  explicit PlaneAxes(const AxisPlane& plane)
      : normal(plane.axis),
        u((plane.axis + 1) % 3),
        v((plane.axis + 2) % 3),
        height(plane.height) {}

  Vec2 project(const Vec3& point) const { return {point[u], point[v]}; }
  Vec3 lift(const Vec2& point) const {
    Vec3 lifted;
    lifted[normal] = height;
    lifted[u] = point.x;
    lifted[v] = point.y;
    return lifted;
  }

  int normal;
  int u;
  int v;
  double height;
};

std::int32_t new_patch(const std::string& name, SurfaceMesh& surface) {
  const auto is_taken = [&surface](const std::string& wanted) {
    const std::vector<std::string>& names = surface.patch_names;
    return std::find(names.begin(), names.end(), wanted) != names.end();
  };
  std::string free = name;
  for (int number = 2; is_taken(free); ++number) free = name + "_" + std::to_string(number);
  surface.patch_names.push_back(free);
  return static_cast<std::int32_t>(surface.patch_names.size()) - 1;
}

void add_triangles(const std::vector<Triangle>& triangles, std::int32_t patch,
                   SurfaceMesh& surface) {
  surface.triangles.insert(surface.triangles.end(), triangles.begin(), triangles.end());
  surface.patch_of_triangle.resize(surface.triangles.size(), patch);
}

/// Half the outer boundary, behind the body's vertices and triangles.
void add_outer(const SurfaceMesh& outer, const std::string& name, SurfaceMesh& surface) {
  const auto offset = static_cast<std::int32_t>(surface.vertices.size());
  surface.vertices.insert(surface.vertices.end(), outer.vertices.begin(), outer.vertices.end());
  std::vector<Triangle> triangles;
  for (const auto& [a, b, c] : outer.triangles) {
    triangles.push_back({a + offset, b + offset, c + offset});
  }
  add_triangles(triangles, new_patch(name, surface), surface);
}

[[noreturn]] void refuse_region(const AxisPlane& plane, const PlaneAxes& axes,
                                const PlanarFailure& failure) {
  constexpr std::size_t most_places = 3;
  std::string text = "the loops in which the surface ends there bound no region: " + failure.reason;
  for (std::size_t i = 0; i < std::min(failure.where.size(), most_places); ++i) {
    text += (i == 0 ? " at " : ", ") + text_of(axes.lift(failure.where[i]));
  }
  if (failure.where.size() > most_places) {
    text += " and " + std::to_string(failure.where.size() - most_places) + " more places";
  }
  throw InvalidInput(text, "symmetry " + plane.text());
}

/// The loops as what mesh_region fills, with the vertex of each point.
struct Outline {
  PlanarRegion region;
  std::vector<std::int32_t> vertices;
};

Outline outline_of_loops(const SurfaceMesh& surface,
                         const std::vector<std::vector<std::int32_t>>& loops,
                         const PlaneAxes& axes) {
  std::vector<std::vector<Vec2>> polygons;
  for (const std::vector<std::int32_t>& loop : loops) {
    std::vector<Vec2>& polygon = polygons.emplace_back();
    for (const std::int32_t v : loop) polygon.push_back(axes.project(surface.vertices[at(v)]));
  }
  const std::vector<bool> is_reversed = turned_loops(polygons);
  Outline outline;
  for (std::size_t i = 0; i < loops.size(); ++i) {
    const auto first = static_cast<std::int32_t>(outline.vertices.size());
    const auto count = static_cast<std::int32_t>(loops[i].size());
    outline.vertices.insert(outline.vertices.end(), loops[i].begin(), loops[i].end());
    outline.region.points.insert(outline.region.points.end(), polygons[i].begin(),
                                 polygons[i].end());
    for (std::int32_t k = 0; k < count; ++k) {
      std::array<std::int32_t, 2> edge = {first + k, first + (k + 1) % count};
      if (is_reversed[i]) std::swap(edge[0], edge[1]);
      outline.region.edges.push_back(edge);
    }
  }
  return outline;
}

std::int64_t fill_plane(const PlaneLoops& ends, const std::vector<std::vector<std::int32_t>>& loops,
                        const HalfBodySpacing& spacing, SurfaceMesh& surface) {
  const PlaneAxes axes(ends.plane);
  Outline outline = outline_of_loops(surface, loops, axes);
  const PlanarResult filled =
      mesh_region(outline.region, [&](const Vec2& point) { return spacing(axes.lift(point)); });
  if (filled.failure) refuse_region(ends.plane, axes, *filled.failure);
  for (std::size_t i = outline.vertices.size(); i < filled.mesh.points.size(); ++i) {
    outline.vertices.push_back(static_cast<std::int32_t>(surface.vertices.size()));
    surface.vertices.push_back(axes.lift(filled.mesh.points[i]));
  }
  std::vector<Triangle> triangles;
  for (const auto& [a, b, c] : filled.mesh.triangles) {
    Triangle triangle = {outline.vertices[at(a)], outline.vertices[at(b)], outline.vertices[at(c)]};
    if (ends.side > 0) std::swap(triangle[1], triangle[2]);
    triangles.push_back(triangle);
  }
  add_triangles(triangles, new_patch(symmetry_patch, surface), surface);
  return std::ssize(triangles);
}

}  // namespace

ClosedHalfBody close_half_body(SurfaceMesh body, const AxisPlane& plane, const OuterBoundary& outer,
                               double growth, const MakeHalfBodySpacing& make_spacing) {
  ClosedHalfBody closed;
  closed.ends = find_plane_loops(body, plane);
  closed.surface = std::move(body);
  SurfaceMesh& surface = closed.surface;
  TF_CHECK(surface.sides.empty());
  if (surface.patch_of_triangle.empty()) {
    surface.patch_of_triangle.assign(surface.triangles.size(), 0);
    surface.patch_names = {"surface"};
  }
  std::vector<std::vector<std::int32_t>> loops = closed.ends.loops;
  if (outer.kind != OuterBoundary::Kind::none) {
    const HalfOuterBoundary half =
        half_outer_boundary(surface, outer, growth, closed.ends.plane, closed.ends.side);
    const auto offset = static_cast<std::int32_t>(surface.vertices.size());
    add_outer(half.surface, half.name, surface);
    for (std::vector<std::int32_t>& rim : open_loops(half.surface, closed.ends.plane)) {
      for (std::int32_t& v : rim) v += offset;
      loops.push_back(std::move(rim));
    }
  }
  closed.plane_triangles = fill_plane(closed.ends, loops, make_spacing(surface), surface);
  return closed;
}

}  // namespace tetfarm
