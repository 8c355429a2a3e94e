/// Of a part of several regions, which of them its boundary triangles bound: formats tell it of
/// tets.
#pragma once

#include "mesh/assemble/portion.h"

namespace tetfarm {

/// Sets part.region_of_face, and the regions of its boundary quads: each is of the region of the
/// cell that has it, turned the same way; a triangle that no cell has is of `part.region`. Cost:
/// O(n log n).
void set_regions_of_faces(NumberedPart& part);

}  // namespace tetfarm
