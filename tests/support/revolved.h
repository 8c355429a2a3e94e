/// Turned solids: shafts, cones, bolts. Valid by construction: the corners of a row are one ring of
/// whole numbers times a factor, so shoulders and the quads of cones are exactly flat.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/core/surface_mesh.h"
#include "tests/support/grid_polygon.h"

namespace tetfarm::shapes {

/// A corner of the outline: the ring times `radius`, at height `z`.
struct RevolvedRow {
  std::int64_t radius = 1;
  std::int64_t z = 0;
};

/// How the ends are triangulated: a fan from a corner of the rim, one round an added node in the
/// middle, or a strip of needles across.
enum class EndCap : std::uint8_t { rim_fan, middle_fan, strip };

EndCap any_cap(Chance& chance);

/// Two adjoining rows differ; z does not fall, and rows of one z have radii that only grow or only
/// shrink. Radius 0 is for the first or last row: a tip. Diagonals of the quads by chance.
/// @pre the ring is strictly convex round the origin.
SurfaceMesh revolved(const Loop& ring, std::span<const RevolvedRow> rows, EndCap cap,
                     Chance& chance);

/// Closes a ring of nodes `first` to `first` + ring.size() - 1 that lie at height z. Looks up, or
/// down when turned.
void add_end_cap(SurfaceMesh& mesh, std::int32_t first, std::int32_t count, EndCap cap,
                 bool is_turned);

}  // namespace tetfarm::shapes
