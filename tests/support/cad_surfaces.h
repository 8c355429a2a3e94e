/// Closed surfaces as CAD programs write them, from a seed: needles, caps, fans of hundreds of
/// triangles, large flat faces with many holes, edges with nodes on them.
///
/// Valid by construction: whole coordinates, so that what is flat is so exactly, outlines that keep
/// apart, and no move but exact ones. Size 0 has some dozen triangles, 1 up to some hundred, 2 some
/// thousand, 3 ten thousand, nodes of 2,000 triangles, plates of 1,000 holes.
#pragma once

#include <cstdint>
#include <span>

#include "tests/support/generated_surfaces.h"

namespace tetfarm::shapes {

std::span<const SurfaceGenerator> cad_surface_generators();

/// Turned by a rotation of whole numbers, flattened, moved by a million times its size or scaled by
/// a power of two, or as it is: one of them by the seed. Exact: what is coplanar stays so.
/// @pre whole coordinates up to 2^32.
SurfaceMesh moved_exactly(SurfaceMesh surface, std::uint64_t seed);

}  // namespace tetfarm::shapes
