/// OFF as the list of formats knows it.
#pragma once

#include <array>

#include "mesh/formats/list/format.h"
#include "mesh/formats/off/read_off.h"
#include "mesh/formats/off/write_off.h"

namespace tetfarm {

inline constexpr std::array off_formats = {Format{
    {.name = "off", .endings = {".off"}, .what = "Object File Format", .has_patch_names = false},
    {.read_surface = read_off, .write_surface = write_off}}};

}  // namespace tetfarm
