/// Moves a Steiner point off the boundary, which closes behind it: when the last has left a
/// boundary triangle, that is whole again.
///
/// The point is taken apart into one on each side. Each moves to where it sees its part of the link
/// and the triangles that close the boundary; those become faces of new tets. Source: P. L. George,
/// H. Borouchaki, E. Saltel, "'Ultimate' robustness in meshing an arbitrary polyhedron" (2003),
/// section 4. Cost: as the star of the point.
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/recovery/local_remeshing.h"
#include "mesh/recovery/surface_splitting.h"

namespace tetfarm {

/// The node's number stays with a part inside, if there is one; further parts get new nodes.
/// Outside the domain the tets are the right ones, but flat where a point found no place. False
/// when a part inside found none; then nothing has changed. @pre all faces of the split surface are
/// in the complex and constrained; `triangles` are the whole ones.
bool relocate_steiner_point(LocalRemeshing& mesh, SplitSurface& surface,
                            const std::vector<Triangle>& triangles, std::int32_t node);

}  // namespace tetfarm
