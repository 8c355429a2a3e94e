/// VTKHDF as the list of formats knows it.
#pragma once

#include <array>

#include "mesh/formats/list/format.h"
#include "mesh/formats/vtkhdf/export_vtkhdf.h"
#include "mesh/formats/vtkhdf/vtkhdf_source.h"

namespace tetfarm {

inline constexpr std::array vtkhdf_formats = {
    Format{{.name = "vtkhdf",
            .endings = {".vtkhdf", ".hdf"},
            .what = "VTKHDF, a partition for each sub-domain",
            .holds_parts = true,
            .is_of_tasks = true},
           {.open_mesh = open_vtkhdf, .write_mesh = export_vtkhdf}}};

}  // namespace tetfarm
