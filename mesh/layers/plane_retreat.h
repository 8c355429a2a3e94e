/// The planes that lines of layers run in, triangulated anew where the layers leave them.
///
/// Source: thesis 4.4.1 has layers end on planes of symmetry by hand of the user; here a plane that
/// borders the wall begins where the layers end. What was its edge is moved to their top, vertices
/// between two planes that a line has run past are left out, and the rest is filled by the planar
/// kernel. What lies between the old edge and the new is the sides of cells: boundary quads, and a
/// triangle where one line has a layer more than the next, or triangles alone where cells are
/// divided into tets. No other triangle of the surface is
/// changed.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "mesh/core/surface_mesh.h"
#include "mesh/layers/layer_plan.h"
#include "mesh/layers/wall_planes.h"

namespace tetfarm {

/// Target edge length at a point; empty: no nodes are wanted within the planes.
using PlaneSpacing = std::function<double(const Vec3&)>;

/// Makes a spacing from triangles whose edges it is to take on; they need not be a closed surface.
using MakePlaneSpacing = std::function<PlaneSpacing(const SurfaceMesh&)>;

struct RetreatFigures {
  std::int64_t planes = 0;            ///< that layers run in
  std::int64_t triangles_before = 0;  ///< of these planes
  std::int64_t triangles_after = 0;   ///< beyond the layers
  std::int64_t quads = 0;             ///< sides of layers, but for those in tets
  std::int64_t side_triangles = 0;

  friend bool operator==(const RetreatFigures&, const RetreatFigures&) = default;
};

/// What lies beyond the layers and beside them, but for the quads.
struct PlaneRetreat {
  SurfaceMesh surface;  ///< the vertices that are left, those of the lines, and those within planes
  LayerPlan plan;       ///< the same lines, by the numbers of this surface
  RetreatFigures figures;
  /// Lines whose tops leave a plane no region; then there is neither surface nor plan.
  std::vector<std::int32_t> tangled;
};

/// Whether some line with layers runs in a plane.
bool runs_in_plane(const LayerPlan& plan, const WallPlanes& planes);

/// @pre planes and plan are of the surface, of one region. Cost: O(n) for n triangles, and
/// mesh_region of each plane.
PlaneRetreat retreat_planes(const SurfaceMesh& surface, const WallPlanes& planes,
                            const LayerPlan& plan, const PlaneSpacing& spacing);

/// The same of a plan of plan_layers; nothing where no line runs in a plane. The spacing is made
/// from what bounds the rest without the planes, so that nodes within a plane fit to the top of the
/// layers, and from old triangles of the planes that are further from the wall than twice the
/// height of the layers. Where nodes within a plane that has no axis would not fit to what is round
/// it, it has none.
std::optional<PlaneRetreat> retreat_planes(const SurfaceMesh& surface, const LayerPlan& plan,
                                           const MakePlaneSpacing& make_spacing);

}  // namespace tetfarm
