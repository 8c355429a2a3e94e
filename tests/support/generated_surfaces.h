/// Closed surfaces made by chance from a seed, to try the volume kernel on: blocked polyhedra,
/// spikes, needles, gaps, knots, grids.
///
/// Sources: E. Schönhardt (1928) and B. Chazelle (1984) for polyhedra that have no tets without
/// added points, the latter with a number of points that grows as the square. A few are invalid
/// after rounding (they cut themselves): the caller asks check_surface, which also orients nested
/// shells. Cost: some hundred triangles each at size 1.
#pragma once

#include <cstdint>
#include <ostream>
#include <span>

#include "mesh/core/surface_mesh.h"

namespace tetfarm::shapes {

struct SurfaceGenerator {
  const char* name;
  /// The same surface for the same seed; `size` 1 is small, 3 some thousand triangles.
  SurfaceMesh (*make)(std::uint64_t seed, int size);
};

/// How a test's parameter is shown.
inline void PrintTo(const SurfaceGenerator& generator, std::ostream* out) {
  *out << generator.name;
}

std::span<const SurfaceGenerator> surface_generators();

/// Turned, flattened, moved by a million times its size or scaled by 1e-9 or 1e9, or as it is: one
/// of them by the seed. What was coplanar may be so no longer.
SurfaceMesh moved_by_chance(SurfaceMesh surface, std::uint64_t seed);

}  // namespace tetfarm::shapes
