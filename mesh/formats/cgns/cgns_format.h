/// CGNS as the list of formats knows it.
#pragma once

#include <array>

#include "mesh/formats/cgns/cgns_source.h"
#include "mesh/formats/cgns/write_cgns.h"
#include "mesh/formats/list/format.h"

namespace tetfarm {

inline constexpr std::array cgns_formats = {Format{
    {.name = "cgns", .endings = {".cgns"}, .what = "CGNS (HDF5), 64-bit", .holds_parts = true},
    {.open_mesh = open_cgns, .write_mesh = write_cgns}}};

}  // namespace tetfarm
