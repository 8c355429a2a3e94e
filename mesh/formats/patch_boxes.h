/// The boxes round the patches of a mesh, and which of them lie in a plane of constant x, y or z:
/// some solvers have a condition of its own for a plane of symmetry of each direction.
#pragma once

#include <optional>
#include <vector>

#include "mesh/core/surface_mesh.h"
#include "mesh/formats/mesh_source.h"

namespace tetfarm {

/// One for each patch of the outline; empty boxes where there are no faces. Reads every part.
/// Memory: one part.
std::vector<Box3> patch_boxes(const MeshSource& source, const MeshOutline& outline);

/// One for each patch name.
std::vector<Box3> patch_boxes(const SurfaceMesh& surface);

/// The axis along which a box has no extent but rounding: a millionth of its largest. Nothing where
/// there is none, or several.
std::optional<int> constant_axis(const Box3& box);

}  // namespace tetfarm
