/// The volume mesh of one sub-domain, on its own (thesis 4.3.3): Delaunay of the boundary points,
/// recovery of the boundary triangles, interior points by the spacing, cosmetics.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>
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

/// The surface could not be recovered: which sub-domain triangles are missing.
class RecoveryFailure : public std::runtime_error {
 public:
  RecoveryFailure(const std::string& message, std::vector<std::int32_t> triangles)
      : std::runtime_error(message), triangles_(std::move(triangles)) {}
  const std::vector<std::int32_t>& triangles() const { return triangles_; }

 private:
  std::vector<std::int32_t> triangles_;
};

/// A mesh that holds every boundary triangle as a face and no added point on the boundary.
/// @pre validate(subdomain) is empty. @throws InvalidInput with sub-domain triangle numbers when
/// the surface cuts itself; RecoveryFailure when it could not be recovered. Cost: about 2 µs an
/// element.
TetMesh mesh_volume(const Subdomain& subdomain, const SpacingField& spacing,
                    const VolumeMeshOptions& options = {}, VolumeMeshReport* report = nullptr);

}  // namespace tetfarm
