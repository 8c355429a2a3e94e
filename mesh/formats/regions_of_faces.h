/// Of a part of several regions, which of them its boundary triangles bound: formats tell it of
/// tets.
#pragma once

#include "mesh/assemble/portion.h"

namespace tetfarm {

/// Sets part.region_of_face, and the regions of its boundary quads: each is of the region of the
/// cell that has it, turned the same way; a triangle that no cell has is of `part.region`. Cost:
/// O(n log n).
void set_regions_of_faces(NumberedPart& part);

/// Of a part whose cells have been read, each with its region: if that is one for all, it is the
/// part's, and is said once; else boundary faces get theirs as above. Cost: as above.
void set_regions_from_cells(NumberedPart& part);

}  // namespace tetfarm
