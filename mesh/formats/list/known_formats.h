/// The names of all formats, and what can be done with each, without the functions that do it: for
/// those who must not depend on the rooms of the formats, such as the job file.
#pragma once

#include <span>

#include "mesh/formats/list/format.h"

namespace tetfarm {

struct KnownFormat : FormatFacts {
  bool reads_surfaces = false;
  bool writes_surfaces = false;
  bool reads_meshes = false;
  bool writes_meshes = false;
};

/// In the order of the lines in CMakeLists.txt.
std::span<const KnownFormat> known_formats();

}  // namespace tetfarm
