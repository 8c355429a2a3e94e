/// Splits a tet by a new node and moves that together with its neighbours: for the very few worst,
/// which neither a split nor a move helps by itself.
///
/// Source: none in the thesis. Where a node is held on several sides, tets on all of them are
/// equally bad in the end. A split helps one of them at most; only with the new node in its place
/// may the other one leave it, and help the rest.
#pragma once

#include "mesh/cosmetics/cavity.h"

namespace tetfarm::cosmetics {

/// Splits tet t where that is best for its cavity, even if it gets worse, and moves the new node
/// and its inner neighbours until no tet round them is as bad as t was, by the margin, or lower
/// than the lowest that was there; they climb to `enough` at most. The new node is put no nearer to
/// others than `least_distance` before it moves. The tets that were changed; none when it did not
/// come to that, and all is as it was but for numbers of tets and a point that is not used. Cost:
/// that of find_split and climb_together, some 5 ms at most.
std::vector<std::int32_t> split_together(WorkMesh& work, std::int32_t t, double enough,
                                         double least_distance);

}  // namespace tetfarm::cosmetics
