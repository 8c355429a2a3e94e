/// Makes the path of the loops over the surface short and simple; the nodes stay, the path moves.
///
/// Source: thesis 4.3.1.8, figure 61 (no path round two edges of a triangle), 4.3.1.6, figure 54
/// (loops must be singly connected). Without this, three times as many planes must be tried
/// (measured).
#pragma once

#include "mesh/core/subdomain.h"
#include "mesh/decompose/face_colouring.h"

namespace tetfarm {

/// A triangle with two or three edges on the path changes colour, until there is none. The path
/// gets shorter with each step, so this ends. Cost: O(n).
void smooth_edge_path(FaceColours& colours, const SurfaceTopology& topology);

/// At a node that the path passes twice or more, the smallest fans change colour until it passes
/// once. Returns how many nodes were changed. Cost: O(n).
int open_pinches(FaceColours& colours, const SurfaceTopology& topology,
                 const std::vector<Triangle>& triangles);

/// Connected patches of one colour with at most ten triangles, and not a whole shell, change
/// colour. Returns how many. Cost: O(n).
int drop_crumbs(FaceColours& colours, const SurfaceTopology& topology);

/// All of these in turn until nothing changes (or a few rounds are over).
void tidy_path(FaceColours& colours, const SurfaceTopology& topology,
               const std::vector<Triangle>& triangles);

}  // namespace tetfarm
