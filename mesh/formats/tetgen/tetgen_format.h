/// TetGen's files as the list of formats knows them.
#pragma once

#include <array>

#include "mesh/formats/list/format.h"
#include "mesh/formats/tetgen/read_tetgen.h"
#include "mesh/formats/tetgen/tetgen_source.h"
#include "mesh/formats/tetgen/write_tetgen.h"

namespace tetfarm {

inline constexpr std::array tetgen_formats = {
    Format{{.name = "poly", .endings = {".poly", ".smesh"}, .what = "TetGen .poly and .smesh"},
           {.read_surface = read_tetgen}},
    Format{{.name = "tetgen",
            .endings = {".node", ".ele"},
            .what = "TetGen .node, .face, .ele",
            .layout = FormatLayout::several_files,
            .cells = FormatCells::tets,
            .integer_bits = 32,
            .has_patch_names = false},
           {.open_mesh = open_tetgen, .write_mesh = write_tetgen}}};

}  // namespace tetfarm
