#include "mesh/shapes/swept_wing.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "base/check.h"
#include "base/error.h"
#include "mesh/core/complaints.h"
#include "mesh/shapes/circle_point.h"
#include "mesh/shapes/patched_surface.h"
#include "mesh/shapes/wing_section.h"

namespace tetfarm {
namespace {

constexpr double far_radius = 10;
constexpr double half_span = 1.2;
constexpr double taper = 0.5;
constexpr double quarter_turn = 0x1.921fb54442d18p+0;
constexpr double row_height = 0x1.bb67ae8584caap-1;  // of equilateral triangles
constexpr double coarsest = far_radius / 4;

/// Half a ring with both its ends; the lower half mirrors the upper one.
struct HalfRing {
  VertexRow upper;
  VertexRow lower;

  /// From the trailing edge over the upper side and back.
  VertexRow whole() const {
    VertexRow row = upper;
    row.insert(row.end(), lower.rbegin() + 1, lower.rend() - 1);
    return row;
  }
};

HalfRing add_ring(PatchedSurface& surface, const std::vector<Vec3>& upper) {
  HalfRing ring;
  for (const Vec3& p : upper) ring.upper.push_back(surface.add_vertex(p));
  ring.lower.push_back(ring.upper.front());
  for (std::size_t i = 1; i + 1 < upper.size(); ++i) {
    ring.lower.push_back(surface.add_vertex({upper[i].x, upper[i].y, -upper[i].z}));
  }
  ring.lower.push_back(ring.upper.back());
  return ring;
}

/// How far the rings round the section reach: the steps grow as the spacing does, and the last
/// arrives at the far field.
std::vector<double> reaches_of_rings(double spacing, double growth) {
  std::vector<double> reaches = {0};
  while (reaches.back() < far_radius) {
    const double h = std::min(spacing + growth * reaches.back(), coarsest);
    reaches.push_back(reaches.back() + row_height * h);
  }
  const double to_far_field = far_radius / reaches.back();
  for (double& reach : reaches) reach *= to_far_field;
  reaches.back() = far_radius;
  return reaches;
}

/// Returns the rim of the far field.
VertexRow add_symmetry_plane(PatchedSurface& surface, const std::vector<SectionPoint>& half,
                             const HalfRing& root, double spacing, double growth) {
  surface.begin_patch("symmetry");
  const std::vector<double> reaches = reaches_of_rings(spacing, growth);
  VertexRow inner = root.whole();
  for (std::size_t i = 1; i < reaches.size(); ++i) {
    const double reach = reaches[i];
    const double h = std::min(spacing + growth * reach, coarsest);
    const std::vector<Vec3> line = upper_line(half, {1 - reach / far_radius, reach});
    std::vector<Vec3> points = even_points(line, parts_of_length(length_of(line), h, 4));
    if (i + 1 == reaches.size()) {
      for (Vec3& p : points) p = far_radius * normalized(p);
    }
    VertexRow outer = add_ring(surface, points).whole();
    surface.zip_rings(inner, outer);
    inner = std::move(outer);
  }
  return inner;
}

void add_far_field(PatchedSurface& surface, VertexRow rim) {
  surface.begin_patch("far field");
  constexpr double half_turn = 2 * quarter_turn;
  const double h = 2 * half_turn * far_radius / static_cast<double>(rim.size());
  const int m = parts_of_length(quarter_turn * far_radius, row_height * h, 2);
  for (int i = 1; i < m; ++i) {
    const auto [radius, y] = circle_point(i, 4 * m);
    const int n = parts_of_length(2 * half_turn * far_radius * radius, h, 5);
    VertexRow next;
    for (int k = 0; k < n; ++k) {
      const auto [c, s] = circle_point(k, n);
      next.push_back(surface.add_vertex(far_radius * Vec3{radius * c, y, radius * s}));
    }
    surface.zip_rings(rim, next);
    rim = std::move(next);
  }
  surface.zip_rings(rim, {surface.add_vertex({0, far_radius, 0})});
}

/// The flat end, in columns from the lower to the upper side.
void add_tip(PatchedSurface& surface, const HalfRing& tip, double spacing) {
  TF_CHECK(tip.upper.size() == tip.lower.size());
  VertexRow behind = {tip.upper.front()};
  for (std::size_t i = 1; i < tip.upper.size(); ++i) {
    VertexRow column = {tip.lower[i]};
    if (tip.lower[i] != tip.upper[i]) {
      const Vec3 low = surface.at(tip.lower[i]);
      const Vec3 high = surface.at(tip.upper[i]);
      const int parts = parts_of_length(distance(low, high), spacing, 1);
      for (int k = 1; k < parts; ++k) {
        column.push_back(surface.add_vertex(low + (high - low) * k / parts));
      }
      column.push_back(tip.upper[i]);
    }
    surface.zip(column, behind);
    behind = std::move(column);
  }
}

void add_wing(PatchedSurface& surface, const std::vector<Vec3>& section, const HalfRing& root,
              double spacing) {
  surface.begin_patch("wing");
  const double length = length_of(section);
  // The sweep turns rows of this height into equilateral triangles.
  const int rows = parts_of_length(half_span, row_height * spacing, 2);
  HalfRing inner = root;
  for (int i = 1; i <= rows; ++i) {
    const double y = half_span * i / rows;
    const double chord = 1 - (1 - taper) * i / rows;
    const Vec3 middle{y / std::sqrt(3.0) + 0.5 * (chord - 1), y, 0};
    std::vector<Vec3> points = even_points(section, parts_of_length(length * chord, spacing, 4));
    for (Vec3& p : points) p = middle + chord * p;
    HalfRing outer = add_ring(surface, points);
    surface.zip(outer.upper, inner.upper);
    surface.zip(inner.lower, outer.lower);
    inner = std::move(outer);
  }
  add_tip(surface, inner, spacing);
}

}  // namespace

SurfaceMesh swept_wing(double spacing, double growth) {
  if (!(growth >= 0.01 && growth <= 1)) {
    throw UsageError("the growth must be between 0.01 and 1; it is " + text_of(growth), "--growth");
  }
  if (!(spacing > 0 && spacing <= 0.2)) {
    throw UsageError(
        "the spacing must be positive and at most 0.2, or the wing has no shape; it is " +
            text_of(spacing),
        "--spacing");
  }
  const std::vector<SectionPoint> half = upper_half();
  const std::vector<Vec3> section = upper_line(half, {});
  PatchedSurface surface;
  const HalfRing root =
      add_ring(surface, even_points(section, parts_of_length(length_of(section), spacing, 4)));
  VertexRow rim = add_symmetry_plane(surface, half, root, spacing, growth);
  add_wing(surface, section, root, spacing);
  add_far_field(surface, std::move(rim));
  return surface.take();
}

}  // namespace tetfarm
