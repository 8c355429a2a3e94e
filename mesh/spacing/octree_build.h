/// Builds the spacing octree: refine to the demand, balance 2:1, put the spacing on the corners.
///
/// Source: docs/kernel.md, "Points inside".
///
/// A cell is split while its edge exceeds cell_fit * h / lattice_ratio, h being the spacing at its
/// centre (or twice the smallest in it, if less). As edges go by powers of two, a leaf's edge then
/// lies between 0.8 and 1.6 of the ideal h / lattice_ratio, and the lattice has 1.2 to 1.4 times
/// the elements that the spacing asks for; with 1 instead of cell_fit nearly five times (measured:
/// docs/decisions/0004-spacing-octree.md). The root's edge is a power of two times the ideal cell
/// of the background, or else of the median surface spacing, so a uniform job gets the ideal cell
/// itself.
#pragma once

#include "mesh/spacing/spacing_demand.h"
#include "mesh/spacing/spacing_octree.h"

namespace tetfarm {

/// Spacing over cell edge of the body-centred lattice whose tets have the spacing as mean edge.
inline constexpr double lattice_ratio = 0.92;
inline constexpr double cell_fit = 1.6;
/// Cells are at most 2^-3 of the root.
inline constexpr int coarsest_level = 3;
inline constexpr std::int32_t most_leaves = 1 << 25;

/// The ideal cell edge of a spacing, less the bits after its 20 first: products with grid positions
/// are then exact.
double ideal_cell(double spacing);

/// A cube round the domain whose cells can have the edge ideal_cell(reference), slightly larger
/// than the domain.
/// @pre reference > 0. @throws InvalidInput when the domain is too far from the origin for its
/// size.
GridFrame grid_frame(const Box3& domain, double reference);

/// @throws InvalidInput when the spacing asks for more than most_leaves cells.
/// Cost: O(n log n) for n demands and cells.
SpacingOctree build_octree(const SpacingDemand& demand, const GridFrame& frame, const Box3& domain);

}  // namespace tetfarm
