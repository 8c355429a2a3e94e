/// Wavefront OBJ as the list of formats knows it.
#pragma once

#include <array>

#include "mesh/formats/list/format.h"
#include "mesh/formats/obj/read_obj.h"

namespace tetfarm {

inline constexpr std::array obj_formats = {Format{
    {.name = "obj", .endings = {".obj"}, .what = "Wavefront OBJ"}, {.read_surface = read_obj}}};

}  // namespace tetfarm
