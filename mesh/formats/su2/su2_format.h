/// SU2 as the list of formats knows it.
#pragma once

#include <array>

#include "mesh/formats/list/format.h"
#include "mesh/formats/su2/read_su2.h"
#include "mesh/formats/su2/su2_source.h"
#include "mesh/formats/su2/write_su2.h"

namespace tetfarm {

inline constexpr std::array su2_formats = {
    Format{{.name = "su2", .endings = {".su2"}, .what = "SU2", .has_regions = false},
           {.read_surface = read_su2,
            .open_mesh = open_su2,
            .write_mesh = write_su2,
            .write_beside = write_beside_su2}}};

}  // namespace tetfarm
