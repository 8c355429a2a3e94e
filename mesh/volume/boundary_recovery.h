/// Makes every boundary triangle a face of the complex, with no added point left on the boundary
/// (thesis 4.3.3).
///
/// Order of attack: the Delaunay tets hold nearly all; missing edges by flips, then missing faces
/// by flips, with searches that go deeper from pass to pass; what is still missing is split by
/// Steiner points, which are then moved off the boundary (steiner_relocation.h). Cost: about the
/// number of tets when little is missing.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "mesh/volume/local_remeshing.h"
#include "mesh/volume/recovery_surface.h"

namespace tetfarm {

struct RecoveryReport {
  std::int64_t missing_edges = 0;  // in the Delaunay tets
  std::int64_t missing_faces = 0;  // once all edges were there
  std::int64_t steiner_points = 0;
  std::vector<std::array<std::int32_t, 2>> lost_edges;  // not recovered
  std::vector<std::int32_t> lost_triangles;
};

/// On success (nothing lost) all boundary faces are constrained on both sides.
/// @pre the complex holds every node of the surface.
RecoveryReport recover_boundary(LocalRemeshing& mesh, const RecoverySurface& surface);

/// The surface's edges that are not in the complex, in increasing order.
std::vector<std::array<std::int32_t, 2>> missing_edges(const TetComplex& complex,
                                                       const RecoverySurface& surface);

/// Constrains every face of the surface that is in the complex; returns the triangles that are not.
std::vector<std::int32_t> constrain_faces(LocalRemeshing& mesh, const RecoverySurface& surface);

}  // namespace tetfarm
