/// A mesh of the plane as an OpenFOAM case: constant/polyMesh of one layer of prisms.
///
/// Source: OpenFOAM user guide, "Mesh files", and "2D and axi-symmetric problems". The prisms stand
/// on z = 0 and are 1 high, so that forces are those of a unit of span. Front and back are one
/// patch `frontAndBack` of type `empty`; patches that bound holes of the domain alone, or whose
/// name begins or ends with "wall", are of type `wall`, others of type `patch`. Several regions are
/// cell zones; edges between them are faces inside.
#pragma once

#include <filesystem>

#include "mesh/planar/plane_mesh.h"

namespace tetfarm {

/// `folder` is the case; constant/polyMesh is made in it. Faces are in upper triangular order.
/// Nodes that no triangle uses are left out.
/// @throws IoError; InvalidInput when more than two triangles have a side; Error when there are
/// more than labels of 32 bits can count. Cost: O(n log n).
void write_plane_foam(const PlaneMesh& mesh, const std::filesystem::path& folder);

}  // namespace tetfarm
