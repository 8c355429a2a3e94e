/// Meshes of needles, where most tets are bad: worst first in stages, each with its own number of
/// attempts, so that the worst get what can be done for them and the whole ends in bounded time.
///
/// A tessellation of needles leaves no room for good tets; with passes to no end every tet is tried
/// dozens of times for a gain of next to nothing. Measured:
/// docs/decisions/0007-cosmetics-measure.md. Cost: some 40 attempts for each tet that is bad when
/// its stage begins, and 200 for each node of the boundary at most, 20 to 40 µs each.
#pragma once

#include <cstddef>
#include <vector>

#include "mesh/cosmetics/improver.h"

namespace tetfarm::cosmetics {

/// Whether so many of the tets are really bad that stages are called for.
bool is_of_needles(const std::vector<BadTet>& bad, std::size_t tets);

/// All stages but the last, which is the improver's own aims: what falls short of them is queued
/// then, and its attempts are counted out. From now on a change must gain more.
void improve_in_stages(Improver& improver);

/// What is still worst, once more: its surroundings have changed. What falls short of the
/// improver's own aims is given up then; a few attempts remain.
void improve_worst_again(Improver& improver);

}  // namespace tetfarm::cosmetics
