/// The mesher in one call, for programs that link it: a surface becomes tets, in memory.
///
/// The same mesh, node by node, as `tetfarm run` makes of the surface with one sub-domain for each
/// region. Nothing is written, no other process is started; several calls may run side by side.
/// Larger meshes than fit into memory are what the program `tetfarm` is for.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "mesh/core/surface_mesh.h"
#include "mesh/core/tet_mesh.h"
#include "mesh/inspect/surface_check.h"
#include "mesh/spacing/spacing_field.h"
#include "mesh/volume/volume_mesh.h"

namespace tetfarm {

struct MeshSurfaceOptions {
  SpacingOptions spacing;  ///< edge lengths: everywhere, growth, sources
  OuterBoundary outer;     ///< to mesh the space round a body instead of its inside
  RegionRules regions;     ///< names, and what is not meshed
  VolumeMeshOptions volume;
};

/// Invariants: `nodes` begin with the vertices of `surface`, bit by bit; `region_of_tet` has one
/// entry for each tet; the tets of a region, and the triangles of `surface` that bound it, are a
/// TetMesh (mesh/core/tet_mesh.h), but that vertices of other regions are not used.
struct MeshedSurface {
  SurfaceMesh surface;  ///< what is meshed: turned to point outward, with the outer boundary
  std::vector<Vec3> nodes;
  std::vector<Tet> tets;
  std::vector<std::int32_t> region_of_tet;  ///< from 1, as surface.region_names
};

/// The boundary of a region could not be recovered: which of its triangles are missing.
class RecoveryFailure : public std::runtime_error {
 public:
  RecoveryFailure(const std::string& message, std::vector<std::int32_t> triangles)
      : std::runtime_error(message), triangles_(std::move(triangles)) {}
  /// Numbers among the triangles of the region, in the order of the surface.
  const std::vector<std::int32_t>& triangles() const { return triangles_; }

 private:
  std::vector<std::int32_t> triangles_;
};

/// @throws InvalidInput when the surface cannot be meshed: what is wrong, with triangle numbers and
/// coordinates; UsageError for options that make no sense; RecoveryFailure when the boundary was
/// not recovered, which is a defect of this library. Deterministic. Cost: about 3 µs a tet.
MeshedSurface mesh_surface(const SurfaceMesh& surface, const MeshSurfaceOptions& options = {});

}  // namespace tetfarm
