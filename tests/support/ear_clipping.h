/// Triangles of a polygon with holes, as simple CAD exporters make them: needles and fans.
///
/// Source: ear clipping (G. Meisters 1975), holes joined to the outline by bridges (D. Eberly,
/// "Triangulation by Ear Clipping"). All tests are exact.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "tests/support/grid_polygon.h"

namespace tetfarm::shapes {

/// The ear of lowest number, which makes fans, or each next one along the path.
enum class EarOrder : std::uint8_t { lowest, next };

/// Triangles, anticlockwise, of positive area, without any added point: all sides of the loops are
/// edges, and corners within a straight side stay such. `loops`: the outline, anticlockwise, then
/// the holes, clockwise; no two touch. The corners are counted through all loops.
/// Cost: O(corners x reflex corners). Stops the process on loops that cut each other.
std::vector<std::array<std::int32_t, 3>> clip_ears(const std::vector<Loop>& loops, EarOrder order);

}  // namespace tetfarm::shapes
