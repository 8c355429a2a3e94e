/// PLY as the list of formats knows it.
#pragma once

#include <array>

#include "mesh/formats/list/format.h"
#include "mesh/formats/ply/read_ply.h"

namespace tetfarm {

inline constexpr std::array ply_formats = {
    Format{{.name = "ply", .endings = {".ply"}, .what = "PLY"}, {.read_surface = read_ply}}};

}  // namespace tetfarm
