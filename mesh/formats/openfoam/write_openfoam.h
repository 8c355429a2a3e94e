/// Writes a mesh for OpenFOAM: constant/polyMesh of a case, or decomposed as it was meshed, a
/// processor for each sub-domain.
///
/// Source: OpenFOAM user guide, "Mesh files". Text, so that builds with labels of 32 and of 64 bits
/// read it. Patches have plain names, and the type `wall` or `symmetry` where they are
/// specified so, else `patch`; regions are cell zones when there are
/// several, and triangles between two of them are faces inside.
#pragma once

#include <filesystem>

#include "mesh/formats/mesh_source.h"

namespace tetfarm {

/// `folder` is the case; constant/polyMesh is made in it, and what write_foam_system makes. Faces
/// are in upper triangular order.
/// @throws IoError, InvalidInput, what the source throws. Two passes; memory of one part.
void write_openfoam(const MeshSource& source, const MeshOutline& outline,
                    const std::filesystem::path& folder);

/// processorN/constant/polyMesh for each sub-domain N, with processor patches whose faces come in
/// the same order on both sides. Cells and points have the order of the sub-domain.
/// @throws as above.
void write_openfoam_decomposed(const MeshSource& source, const MeshOutline& outline,
                               const std::filesystem::path& folder);

}  // namespace tetfarm
