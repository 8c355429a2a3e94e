/// Coordinates as text with all digits: who reads them gets the same numbers.
#pragma once

#include <string>

#include "mesh/core/vec3.h"

namespace tetfarm {

/// Appends the three numbers, a space between two, and the end of a line. As few digits as tell the
/// number.
void append_coordinates(std::string& text, const Vec3& p);

}  // namespace tetfarm
