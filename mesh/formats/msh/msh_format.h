/// Gmsh's formats as the list of formats knows them.
#pragma once

#include <array>

#include "mesh/formats/list/format.h"
#include "mesh/formats/msh/msh_source.h"
#include "mesh/formats/msh/read_msh.h"
#include "mesh/formats/msh/write_msh22.h"
#include "mesh/formats/msh/write_msh41.h"
#include "mesh/formats/msh/write_msh41_split.h"

namespace tetfarm {

inline constexpr std::array msh_formats = {
    Format{{.name = "msh41", .endings = {".msh"}, .what = "Gmsh 4.1, binary", .holds_parts = true},
           {.read_surface = read_msh, .open_mesh = open_msh, .write_mesh = write_msh41_binary}},
    Format{{.name = "msh41-text",
            .what = "Gmsh 4.1, text",
            .other_ending = ".msh",
            .holds_parts = true},
           {.write_mesh = write_msh41_text}},
    Format{{.name = "msh41-split",
            .what = "Gmsh 4.1, a file for each sub-domain",
            .other_ending = ".msh",
            .layout = FormatLayout::several_files,
            .holds_parts = true},
           {.write_mesh = write_msh41_split}},
    Format{{.name = "msh41-ghosts",
            .what = "Gmsh 4.1, a file for each sub-domain, with ghost elements",
            .other_ending = ".msh",
            .layout = FormatLayout::several_files,
            .holds_parts = true},
           {.write_mesh = write_msh41_ghosts}},
    Format{{.name = "msh22",
            .what = "Gmsh 2.2, text",
            .other_ending = ".msh",
            .integer_bits = 32,
            .holds_parts = true},
           {.write_mesh = write_msh22}}};

}  // namespace tetfarm
