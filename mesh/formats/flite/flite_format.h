/// FLITE's surface as the list of formats knows it.
#pragma once

#include <array>

#include "mesh/formats/flite/read_fro.h"
#include "mesh/formats/list/format.h"

namespace tetfarm {

inline constexpr std::array flite_formats = {Format{
    {.name = "fro", .endings = {".fro"}, .what = "FLITE's surface"}, {.read_surface = read_fro}}};

}  // namespace tetfarm
