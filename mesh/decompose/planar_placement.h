/// Which planes to try for a cut, the most promising first.
///
/// Source: thesis 4.3.1.4: orthogonal to an axis, or to a principal direction of the inertia
/// matrix. Departures: positions are quantiles of the work, not of boundary faces; several of them,
/// along all axes, are offered, since the first plane often does not pass the checks. Further
/// candidates are planes of the point lattice's {110} family (docs/kernel.md, "Planes of the
/// lattice").
#pragma once

#include <optional>
#include <vector>

#include "mesh/core/subdomain.h"
#include "mesh/decompose/cut_plane.h"
#include "mesh/decompose/surface_topology.h"
#include "mesh/decompose/work_estimate.h"
#include "mesh/spacing/spacing_field.h"

namespace tetfarm {

struct PlaneCandidate {
  CutPlane plane;
  /// The share of the work below the plane.
  double left_share = 0;
  /// Smaller is better: imbalance, size of the cut in elements, invalid zones; less where the cut
  /// can be made of the lattice's faces.
  double penalty = 0;
  /// Of a plane of the lattice: its nodes are to be nodes of the cut.
  std::optional<LatticePlane> lattice;
};

struct PlacementOptions {
  CutPlanes planes = CutPlanes::automatic;
  /// Of the work, wanted below the plane.
  double left_share = 0.5;
  int most = 36;
};

/// At most `options.most` planes.
/// Deterministic. Cost: O(s log s) for s samples, and O(triangles) a direction.
std::vector<PlaneCandidate> place_planes(const Subdomain& subdomain,
                                         const SurfaceTopology& topology, const WorkSamples& work,
                                         const SpacingField& spacing,
                                         const PlacementOptions& options);

}  // namespace tetfarm
