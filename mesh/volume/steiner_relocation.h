/// Moves a Steiner point off the boundary into the domain, so that the boundary triangles that it
/// split are whole again.
///
/// The point moves to where it sees its link and the whole triangles; those become faces of new
/// tets. Source: P. L. George, H. Borouchaki, E. Saltel, "'Ultimate' robustness in meshing an
/// arbitrary polyhedron" (2003), section 4. Cost: as the star of the point.
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/core/tet_complex.h"
#include "mesh/volume/surface_splitting.h"

namespace tetfarm {

/// False when no such place was found; then nothing has changed.
/// @pre the complex holds the inside only, and of all splits the given one is the last not yet
/// undone.
bool relocate_steiner_point(TetComplex& complex, std::vector<std::uint8_t>& constrained,
                            const SteinerSplit& split);

}  // namespace tetfarm
