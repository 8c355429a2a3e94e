/// Which way closed loops of the plane have to run for the region between them to be on their left.
#pragma once

#include <vector>

#include "mesh/geometry/predicates.h"

namespace tetfarm {

/// Twice the area inside a closed loop; positive when it turns anticlockwise. Rounded.
double twice_area(const std::vector<Vec2>& loop);

/// Of each loop whether it has to be reversed. The region is inside of loops that lie in none, or
/// in two, and outside of those that lie in one, or in three. Exact for loops that do not meet.
/// @pre each has three points or more. Cost: O(n) for each loop whose box lies in others.
std::vector<bool> turned_loops(const std::vector<std::vector<Vec2>>& loops);

}  // namespace tetfarm
