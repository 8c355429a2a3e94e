/// First layers that are as high above each face as was asked for, at feet where faces turn both
/// towards each other and away: a line that is long enough for the face that it sees worst is too
/// long for the others there.
///
/// Source: none; each face asks that the mean height at its three corners lies between two bounds,
/// and each corner that it is not too low. All of these are convex, and projecting on one after the
/// other, as S. Kaczmarz solves linear equations (1937), goes to lines that fulfil them all, where
/// there are such. Lines that serve a face worse at the start are moved more. + - * / and square
/// roots only, face by face in their order.
#pragma once

#include <span>
#include <vector>

#include "mesh/core/vec3.h"
#include "mesh/layers/line_lean.h"

namespace tetfarm {

/// Turns and shortens or lengthens the lines of faces whose first height would be off by more than
/// a hundredth, and of those round them. Where no lines fulfil that, as few faces as can be are
/// off, by no more than a tenth as long as there are lines for it.
/// @param along LayerLine::along; where it is zero there are no layers. @param held lines that stay
/// as they are. Lines in planes stay in them. Cost: O(n), and at most 400 rounds over the faces
/// round those that are off.
void level_first_heights(const LineGround& ground, const std::vector<bool>& held,
                         std::vector<Vec3>& along);

}  // namespace tetfarm
