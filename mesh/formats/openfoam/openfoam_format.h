/// OpenFOAM's cases as the list of formats knows them.
#pragma once

#include <array>

#include "mesh/formats/list/format.h"
#include "mesh/formats/openfoam/openfoam_source.h"
#include "mesh/formats/openfoam/write_openfoam.h"

namespace tetfarm {

inline constexpr std::array openfoam_formats = {
    Format{{.name = "openfoam",
            .what = "OpenFOAM constant/polyMesh",
            .folders = "OpenFOAM cases",
            .layout = FormatLayout::folder,
            .integer_bits = 32},
           {.open_mesh = open_openfoam,
            .is_mesh_folder = is_openfoam_case,
            .write_mesh = write_openfoam}},
    Format{{.name = "openfoam-decomposed",
            .what = "OpenFOAM, a processor for each sub-domain",
            .layout = FormatLayout::folder,
            .integer_bits = 32,
            .holds_parts = true},
           {.write_mesh = write_openfoam_decomposed}}};

}  // namespace tetfarm
