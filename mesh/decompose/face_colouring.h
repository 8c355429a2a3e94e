/// Colours: which side of the cut each surface triangle goes to.
///
/// Source: thesis 4.3.1.8, figures 59 and 60. A departure, for robustness: triangles are coloured
/// first (by the side of their centroid) and the loops are then read off as the edges between
/// colours; such edges always close, and their orientation comes from the triangles.
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/decompose/cut_plane.h"
#include "mesh/decompose/surface_topology.h"

namespace tetfarm {

enum class Side : std::uint8_t { left, right };
constexpr Side other(Side side) { return side == Side::left ? Side::right : Side::left; }
using FaceColours = std::vector<Side>;

/// Left is below the plane. Cost: O(n).
FaceColours colour_by_centroid(const SurfaceTopology& topology, const CutPlane& plane);

/// How many of the triangle's edges lie between colours.
int edges_between_colours(const FaceColours& colours, const SurfaceTopology& topology,
                          std::int32_t triangle);

}  // namespace tetfarm
