/// Medit/GMF as the list of formats knows it.
#pragma once

#include <array>

#include "mesh/formats/list/format.h"
#include "mesh/formats/medit/meshb_source.h"
#include "mesh/formats/medit/read_medit.h"
#include "mesh/formats/medit/write_meshb.h"

namespace tetfarm {

inline constexpr std::array medit_formats = {
    Format{{.name = "mesh", .endings = {".mesh"}, .what = "Medit, text"},
           {.read_surface = read_medit}},
    Format{{.name = "meshb",
            .endings = {".meshb"},
            .what = "Medit (GMF 4), 64-bit",
            .has_patch_names = false},
           {.read_surface = read_medit, .open_mesh = open_meshb, .write_mesh = write_meshb}}};

}  // namespace tetfarm
