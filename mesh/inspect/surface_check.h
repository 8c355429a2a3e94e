/// What `tetfarm check` and the inspect task say of a surface: closed, manifold, oriented, degenerate and
/// duplicate triangles, self-intersections, shells and their nesting, patches, edge lengths.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "mesh/core/surface_mesh.h"

namespace tetfarm {

/// One kind of defect with every triangle it concerns (sorted) and where the first few are.
struct SurfaceDefect {
  std::string kind;     // "open edge", "non-manifold edge", "self-intersection", "degenerate triangle"…
  std::string message;  // what, how many, and the first few triangles with coordinates
  std::vector<std::int64_t> triangles;
};

struct Shell {
  std::vector<std::int32_t> triangles;
  double volume = 0;        // as enclosed, positive
  std::int32_t parent = -1; // the shell that directly contains it
  int depth = 0;            // 0: outermost; even: domain inside, odd: hole
  bool was_flipped = false;
};

struct SurfaceReport {
  std::vector<SurfaceDefect> defects;  // empty: can be meshed
  std::vector<std::string> remarks;    // e.g. "shell 2 was oriented inward; turned by nesting"
  std::vector<Shell> shells;
  double volume = 0;  // of the domain
  double shortest_edge = 0;
  double median_edge = 0;
  double longest_edge = 0;
  double smallest_angle_deg = 0;
  std::int64_t unused_vertices = 0;
};

struct CheckedSurface {
  SurfaceMesh surface;  // consistently oriented by nesting when there are no defects; else as given
  SurfaceReport report;
};

/// Triangles and vertices keep their numbers. Exact tests; touching without piercing, coplanar neighbours
/// included, follows the rule: two triangles intersect when they share a point that is not a shared vertex
/// or edge. Deterministic. Cost: O(n log n) for well-shaped surfaces.
CheckedSurface check_surface(const SurfaceMesh& surface);

/// Writes the triangles of all defects, with the defect's number on each, as a .vtp (XML PolyData) file.
void write_defects_vtp(const SurfaceMesh& surface, const std::vector<SurfaceDefect>& defects,
                       const std::string& path);

struct OuterBoundary {
  enum class Kind { none, box, sphere } kind = Kind::none;
  /// The box is the body's bounding box grown to `factor` times its largest side on every side…: the
  /// largest half extent is factor times the body's; a sphere's radius is factor times half the diagonal.
  double factor = 0;
  /// Edge length of its triangles; 0: from the body's longest edge and growth over the distance.
  double spacing = 0;
};

/// The body turned into a hole in a new outer boundary: body triangles reversed, then the boundary's, with
/// new patches "outer_box" or "outer_sphere". @pre the body is closed and oriented outward.
SurfaceMesh add_outer_boundary(const SurfaceMesh& body, const OuterBoundary& outer, double growth);

}  // namespace tetfarm
