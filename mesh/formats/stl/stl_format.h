/// STL as the list of formats knows it.
#pragma once

#include <array>

#include "mesh/formats/list/format.h"
#include "mesh/formats/stl/read_stl.h"
#include "mesh/formats/stl/write_stl.h"

namespace tetfarm {

inline constexpr std::array stl_formats = {
    Format{{.name = "stl", .endings = {".stl"}, .what = "STL"},
           {.read_surface = read_stl, .write_surface = write_stl}}};

}  // namespace tetfarm
