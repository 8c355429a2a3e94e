/// The in-sphere test in whole numbers, for points that plain doubles leave undecided: those of
/// lattices, of planes and of spheres.
///
/// Doubles are whole multiples of a power of two. Where 62 bits hold the coordinates of all points
/// in multiples of one, and 59 their differences, all is exact in integers of fixed length: in 64
/// bits for neighbours on a lattice, in 128 bits for larger steps, else in digits of 60 bits. Cost:
/// 400 to 1000 instructions; expansions take ten times as many.
#pragma once

#include <optional>

#include "mesh/core/vec3.h"

namespace tetfarm {

/// The sign of insphere(a, b, c, d, e); nothing when they take more bits.
std::optional<int> integer_insphere(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d,
                                    const Vec3& e);

}  // namespace tetfarm
