/// Removes a vertex by drawing one of its edges together.
///
/// Source: M. Botsch and L. Kobbelt, "A remeshing approach to multiresolution modeling" (2004), the
/// second step; the link condition of H. Edelsbrunner et al., "Topology preserving edge
/// contraction" (1999), here by the triangles themselves, so that edges of several sheets are
/// served too.
#pragma once

#include "mesh/remeshing/surface_replacement.h"

namespace tetfarm {

/// Draws `gone` into `kept`, when that keeps the topology, the features and the tolerance, makes no
/// edge at `kept` longer than `longest` times the spacing (or than those that it replaces), and no
/// triangle worse than the worst before and `least_shape`. False: nothing has changed. A corner
/// never goes, a vertex on a curve only along it. Cost: some 10 µs.
bool collapse_edge(RemeshingWork& work, std::int32_t gone, std::int32_t kept, double longest,
                   double least_shape);

}  // namespace tetfarm
