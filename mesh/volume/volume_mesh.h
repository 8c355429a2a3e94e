/// The volume mesh of one sub-domain, on its own (thesis 4.3.3): Delaunay of the boundary points,
/// recovery of the boundary triangles, interior points by the spacing, cosmetics.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/work_progress.h"
#include "mesh/core/subdomain.h"
#include "mesh/core/tet_mesh.h"
#include "mesh/filling/lattice_cost.h"
#include "mesh/spacing/spacing_field.h"

namespace tetfarm {

/// Where the points inside come from: the job's graded lattice (point_insertion.h), or the thesis's
/// sweeps over the tets (sweep_points.h).
enum class InteriorPoints : std::uint8_t { lattice, sweeps };

struct VolumeMeshOptions {
  /// Off: stop after recovery, without interior points or cosmetics (for tests).
  bool fill = true;
  bool cosmetics = true;
  InteriorPoints points = InteriorPoints::lattice;
  WorkProgress progress = {};
};

struct VolumeMeshReport {
  std::int64_t missing_edges = 0;
  std::int64_t missing_faces = 0;
  std::int64_t boundary_steiner_points = 0;  // for a while, to recover the rest
  std::int64_t interior_steiner_points = 0;  // of these, the ones that are left, inside
  LatticeCost lattice;                       // of points from the lattice
  std::int64_t cosmetic_attempts = 0;        // at tets that are bad
};

/// Why a sub-domain has no mesh.
struct VolumeFailure {
  enum class Cause : std::uint8_t { same_place, not_recovered };
  /// Two vertices are at the same place, or no attempt recovered the whole boundary.
  Cause cause = Cause::not_recovered;
  std::string message;                  // begins with the name of the sub-domain
  std::vector<std::int32_t> triangles;  // of the sub-domain: at the vertex, or missing
};

/// Either a mesh, or why there is none.
struct VolumeOutcome {
  std::optional<TetMesh> mesh;
  VolumeFailure failure;
};

/// A mesh that holds every boundary triangle as a face and no added point on the boundary. There
/// is none when two vertices are at the same place, and when the boundary was not recovered, as
/// that of a surface that cuts itself.
/// @pre validate(subdomain) is empty. Cost: about 2 µs an element.
VolumeOutcome mesh_volume(const Subdomain& subdomain, const SpacingField& spacing,
                          const VolumeMeshOptions& options = {},
                          VolumeMeshReport* report = nullptr);

}  // namespace tetfarm
