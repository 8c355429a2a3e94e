/// The boundary round a Steiner point, and how it is cut without the point.
///
/// Of each boundary triangle that the point lies on, the parts at the point fill a polygon; it is
/// cut into triangles of its other corners by cutting ears. Source: G. H. Meisters, "Polygons have
/// ears" (1975). Cost: the surface once; the cube of a polygon's corners.
#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "mesh/recovery/local_remeshing.h"
#include "mesh/recovery/surface_splitting.h"

namespace tetfarm {

/// The parts of one boundary triangle at a node.
struct SurfaceFan {
  std::int32_t source = -1;
  std::vector<std::pair<std::int32_t, std::int32_t>> edges;  // opposite the node, anticlockwise
  std::vector<Triangle> without;  // what fills their place when the node is gone
};

/// Nothing when a polygon has no ears, which exact arithmetic would not allow. `triangles` are the
/// whole boundary triangles.
std::optional<std::vector<SurfaceFan>> surface_fans(const LocalRemeshing& mesh,
                                                    const SplitSurface& surface,
                                                    const std::vector<Triangle>& triangles,
                                                    std::int32_t node);

}  // namespace tetfarm
