/// VTK XML as the list of formats knows it.
#pragma once

#include <array>

#include "mesh/formats/list/format.h"
#include "mesh/formats/pvtu/pvtu_source.h"
#include "mesh/formats/pvtu/write_pvtu.h"

namespace tetfarm {

inline constexpr std::array pvtu_formats = {
    Format{{.name = "pvtu",
            .endings = {".pvtu", ".vtu"},
            .what = "VTK XML, a .vtu for each sub-domain",
            .layout = FormatLayout::several_files,
            .holds_parts = true,
            .has_patch_names = false},
           {.open_mesh = open_pvtu, .write_mesh = write_pvtu}}};

}  // namespace tetfarm
