/// Makes every boundary triangle a face of the complex (thesis 4.3.3).
///
/// Order of attack: the Delaunay tets hold nearly all; missing edges by flips, then missing faces
/// by flips, with searches that go deeper from pass to pass; what is still missing is split by
/// Steiner points, one after the other, and its parts are recovered in the same way. Then the
/// Steiner points leave the boundary again, last in, first out (steiner_relocation.h), and most of
/// them the complex (steiner_settling.h). Cost: about the number of tets when little is missing,
/// and a bounded number of rings for each thing that is (some ms).
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/work_progress.h"
#include "mesh/recovery/local_remeshing.h"
#include "mesh/recovery/recovery_surface.h"

namespace tetfarm {

struct RecoveredBoundary {
  std::int64_t missing_edges = 0;   // in the Delaunay tets
  std::int64_t missing_faces = 0;   // once the edges were done
  std::int64_t splits = 0;          // Steiner points that were needed on the boundary for a while
  std::int64_t steiner_points = 0;  // that are still there, inside: of these, or beside flat facets
  std::vector<std::int32_t> lost;   // boundary triangles that could not be recovered
};

/// `seed`: another order of the flips, for another attempt from the Delaunay tets; 0 is the plain
/// order. Other attempts swap edges inside flat facets as well (facet_flips.h). On success (nothing
/// lost) the boundary's faces are constrained on both sides, and no other. Tets outside may then be
/// flat or turned round at split points, where nothing but walks go.
/// @pre every node of the boundary is in a tet; no face is constrained.
RecoveredBoundary recover_boundary(TetComplex& complex, std::vector<std::uint8_t>& constrained,
                                   const std::vector<Triangle>& triangles, std::uint64_t seed = 0,
                                   const WorkProgress& progress = {});

/// The surface's edges that are not in the complex, in increasing order.
std::vector<std::array<std::int32_t, 2>> missing_edges(const TetComplex& complex,
                                                       const RecoverySurface& surface);

/// Constrains every face of the surface that is in the complex; returns the triangles that are not.
std::vector<std::int32_t> constrain_faces(LocalRemeshing& mesh, const RecoverySurface& surface);

}  // namespace tetfarm
