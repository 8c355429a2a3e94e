/// Reads the mesh of an OpenFOAM case, whole or decomposed
/// (mesh/formats/openfoam/write_openfoam.h).
#pragma once

#include <filesystem>
#include <memory>

#include "mesh/formats/mesh_source.h"

namespace tetfarm {

/// Whether the folder has constant/polyMesh, or processor0/constant/polyMesh.
bool is_openfoam_case(const std::filesystem::path& folder);

/// A whole case, read as a parsed mesh (parsed_mesh.h), or without one its processors, which are
/// the sub-domains: each is read once here, and then as it is wanted. Tets have the order of the
/// cells, but not of their nodes, which the format does not have; cell zones are regions, and each
/// cell must be in one if there are any. Nodes of a decomposed case are numbered anew
/// (processor_numbers.h); its faces between processors are no boundary.
/// @throws IoError, InvalidInput with file and line, or the number of a cell that is no tet.
std::unique_ptr<MeshSource> open_openfoam(const std::filesystem::path& folder,
                                          const std::filesystem::path& scratch_folder);

}  // namespace tetfarm
