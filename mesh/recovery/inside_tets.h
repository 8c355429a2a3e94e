/// Tells the tets of the domain from those outside, once every boundary face is in the complex.
///
/// A boundary triangle's normal points out of the domain, so of its two tets the one behind it is
/// inside; the rest follows by flood fill that stops at constrained faces (thesis 4.3.3). Cost:
/// O(tets).
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/recovery/local_remeshing.h"
#include "mesh/recovery/recovery_surface.h"

namespace tetfarm {

/// A byte for each tet: 1 inside. Dead tets are 0. Empty when the boundary leaks: a tet is reached
/// from both sides, or the outside is.
std::vector<std::uint8_t> inside_tets(const LocalRemeshing& mesh, const RecoverySurface& surface);

/// The inside alone: points below `boundary_nodes` keep their numbers, `dropped` points after them
/// (the enclosing ones) go, the rest move up. Boundary faces have no neighbour and are constrained.
struct InsideComplex {
  TetComplex complex;
  std::vector<std::uint8_t> constrained;
};
InsideComplex keep_inside(const TetComplex& complex, const std::vector<std::uint8_t>& constrained,
                          const std::vector<std::uint8_t>& inside, std::int32_t boundary_nodes,
                          std::int32_t dropped);

}  // namespace tetfarm
