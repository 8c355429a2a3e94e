/// Communication tables as the list of formats knows them.
#pragma once

#include <array>

#include "mesh/formats/communication/communication_table.h"
#include "mesh/formats/list/format.h"

namespace tetfarm {

inline constexpr std::array communication_formats = {
    Format{{.name = "comm",
            .what = "communication tables",
            .layout = FormatLayout::folder,
            .holds_parts = true},
           {.write_mesh = write_communication}},
    Format{{.name = "comm-text",
            .what = "communication tables, text",
            .layout = FormatLayout::folder,
            .holds_parts = true},
           {.write_mesh = write_communication_text}}};

}  // namespace tetfarm
