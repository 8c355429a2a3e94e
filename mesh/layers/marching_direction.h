/// The direction in which layers leave a node: the one that sees the worst of the faces round it
/// best.
///
/// Source: thesis fig. 90 takes the plain average of the normals, which looks from behind at a face
/// of 0.1 to 0.3 % of an aircraft's nodes. This is the axis of the smallest cone round the normals:
/// it is decided by two or three of them, found as E. Welzl finds the smallest disk (1991), one
/// normal after the other. Normals that differ by less than 1e-5 count as one; exact up to that.
/// + - * / and square roots only.
#pragma once

#include <span>

#include "mesh/core/vec3.h"

namespace tetfarm {

/// A direction that sees its worst face at a smaller cosine serves no layers: the line would be
/// more than twenty times as long as the layers are high.
inline constexpr double least_visibility = 0.05;

struct MarchingDirection {
  Vec3 direction;         ///< of length 1; zero where no direction sees all faces
  double visibility = 0;  ///< the smallest cosine between it and a normal
};

/// The smallest cosine between the direction, of length 1, and a normal; 1 without any.
double visibility(const Vec3& direction, std::span<const Vec3> normals);

/// @pre at least one normal, all of length 1. Cost: O(n) for n normals in the order of a fan,
/// O(n^3) at worst.
MarchingDirection marching_direction(std::span<const Vec3> normals);

}  // namespace tetfarm
