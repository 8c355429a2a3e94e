/// The open edges of half a body: the loops in which it ends on its plane of symmetry.
///
/// Source: none in the thesis, whose half bodies come closed. Lengths in the unit of the input.
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/core/axis_plane.h"
#include "mesh/core/surface_mesh.h"

namespace tetfarm {

struct PlaneLoops {
  /// Where the loops lie to the last bit: where they were wanted, or where all of their vertices
  /// are, if that is as good as there.
  AxisPlane plane;
  int side = 1;                                  ///< of the plane, on which the body lies: 1 or -1
  std::vector<std::vector<std::int32_t>> loops;  ///< vertices, one after the other; closed
  std::int64_t moved = 0;                        ///< vertices that were beside the plane
  double farthest_move = 0;
};

/// Vertices on open edges that differ from the plane, and from each other, by no more than a
/// millionth of the surface's size are moved onto it. `surface` may turn its triangles either way.
/// @throws InvalidInput with counts and places when there are no open edges, some lie elsewhere or
/// do not close to loops, the surface reaches through the plane, or a triangle lies in it.
/// Cost: O(n log n).
PlaneLoops find_plane_loops(SurfaceMesh& surface, const AxisPlane& wanted);

/// The loops of open edges of any surface: vertices, one after the other. @param plane for
/// messages.
/// @throws InvalidInput when they do not close to loops that are apart. Cost: O(n log n).
std::vector<std::vector<std::int32_t>> open_loops(const SurfaceMesh& surface,
                                                  const AxisPlane& plane);

}  // namespace tetfarm
