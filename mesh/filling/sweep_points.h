/// Fills the domain with points by the spacing, the thesis's own way: sweeps over the tets, each of
/// which may offer a point at its centroid, until a sweep adds none.
///
/// Source: thesis 3.2 and 4.3.3, by its reference [18], N. P. Weatherill, O. Hassan, "Efficient
/// three-dimensional Delaunay triangulation with automatic point creation and imposed boundary
/// constraints" (1994). Departures: the spacing comes from the job's one field instead of the
/// boundary's edge lengths; candidates go in largest first, and one whose tet is gone by then waits
/// for the next sweep; distances to the others are checked in the cavity, which sees every node
/// nearby. The values and what else was tried: docs/decisions/0010-volume-interior-points.md.
/// Units: distances in local spacings. Cost: about 4 µs a tet, twice the lattice's.
#pragma once

#include <cstdint>
#include <vector>

#include "base/work_progress.h"
#include "mesh/core/tet_complex.h"
#include "mesh/spacing/spacing_field.h"

namespace tetfarm {

struct SweepOptions {
  /// α of [18]: a centroid nearer than this to a node of its own tet is no candidate. Sets how long
  /// the edges are: 0.67 makes them as long as the spacing on average.
  double own_clearance = 0.67;
  /// β of [18]: shortest distance to any other node, those of the same sweep included.
  double other_clearance = 0.6;
  /// Least height over the boundary faces that the point would be joined to.
  double face_clearance = 0.4;
  /// Counts candidates, sweep after sweep.
  WorkProgress progress = {};
};

struct SweepReport {
  std::int64_t sweeps = 0;
  std::int64_t points = 0;
};

/// Appends points to the complex, all in tets with `inside` set. Constrained faces stay.
/// Deterministic: of equally large candidates the first along a Hilbert curve goes in first, then
/// that of the smaller tet number.
/// @pre `inside` has a byte for each tet of the complex and is bounded by constrained faces.
SweepReport sweep_points(TetComplex& complex, std::vector<std::uint8_t>& constrained,
                         const std::vector<std::uint8_t>& inside, const SpacingField& spacing,
                         const SweepOptions& options = {});

}  // namespace tetfarm
