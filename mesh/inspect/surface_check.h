/// What `tetfarm check` and the inspect task say of a surface: closed, manifold, oriented,
/// degenerate and duplicate triangles, self-intersections, shells and their nesting, edge lengths.
///
/// Source: the thesis (4.3.1) takes a valid surface for granted; this room makes sure of it. The
/// parts: triangle_defects, surface_edges, shell_orientation, vertex_fans, self_intersection,
/// shell_nesting; where more than two triangles meet in an edge, or the job names regions:
/// surface_sides, region_map, region_choice.
#pragma once

#include "mesh/core/surface_mesh.h"
#include "mesh/inspect/outer_boundary.h"
#include "mesh/inspect/region_choice.h"
#include "mesh/inspect/surface_report.h"
#include "mesh/inspect/write_defects_vtp.h"

namespace tetfarm {

struct CheckedSurface {
  /// Oriented by nesting, or with sides and region names, when there are no defects; else as given.
  SurfaceMesh surface;
  SurfaceReport report;
};

/// Triangles and vertices keep their numbers. Exact tests; touching without piercing, coplanar
/// neighbours included, follows the rule: two triangles intersect when they share a point that is
/// not a shared vertex or edge. A sharp feature, however thin, is no defect; nor are shells that
/// share single vertices, nor several outermost shells, nor sheets between regions. Deterministic.
/// @throws UsageError when the rules do not fit the surface. Cost: O(n log n) for well-shaped
/// surfaces; memory of a surface that is moved in, and some 150 bytes a triangle besides.
CheckedSurface check_surface(SurfaceMesh given, const RegionRules& rules = {});

}  // namespace tetfarm
