/// What a mesh is round, where there is such a thing: the patches that are small beside the whole.
/// For pictures, which show them whole where the rest is cut.
#pragma once

#include <string>
#include <vector>

#include "mesh/formats/mesh_source.h"

namespace tetfarm {

/// Patches whose diagonal is shorter than 0.4 of that of all; none where Tetfarm made the outer
/// boundary, whose name tells it without such a guess. Cost: reads each part once.
std::vector<std::string> small_patches(const MeshSource& mesh);

}  // namespace tetfarm
