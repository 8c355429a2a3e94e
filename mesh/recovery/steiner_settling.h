/// Makes the Steiner points inside ordinary nodes: most are taken out again by flips, the rest move
/// to the middle of the room they have, to a place that doubles hold exactly.
///
/// Points that have just left the boundary may have less room than doubles tell; it grows as their
/// neighbours go or move. Source: removal of a node by flips down to four tets, as in B. Joe,
/// "Construction of three-dimensional Delaunay triangulations using local transformations" (1991).
/// Cost: as the stars of the points, a few times.
#pragma once

#include <cstdint>
#include <vector>

#include "base/work_progress.h"
#include "mesh/recovery/local_remeshing.h"
#include "mesh/recovery/recovery_surface.h"

namespace tetfarm {

struct SettledPoints {
  std::vector<std::int32_t> kept;       // still in the complex, at places of plain doubles
  std::vector<std::int32_t> unsettled;  // in the complex, but found no such place
};

/// Constrained faces and their edges are left alone. @pre the points came by add_point and none
/// lies on the surface any more. `progress` is told that the work goes on.
SettledPoints settle_steiner_points(LocalRemeshing& mesh, const std::vector<std::int32_t>& points,
                                    const WorkProgress& progress = {});

/// One step of that: takes the point out, or moves it to the middle of its room; nothing when it is
/// in no tet.
void settle_steiner_point(LocalRemeshing& mesh, std::int32_t point);

/// Takes an inner node out of the complex by flips. False: nothing has changed. @pre the surface's
/// faces are all there: being constrained, they guard themselves.
bool remove_node(LocalRemeshing& mesh, std::int32_t node);
/// The same while faces are missing: no edge of the surface that is there is removed.
bool remove_node(LocalRemeshing& mesh, const RecoverySurface& surface, std::int32_t node);

}  // namespace tetfarm
