/// Unites bodies that go through each other, or through themselves.
///
/// Source: Q. Zhou, E. Grinspun, D. Zorin and A. Jacobson, "Mesh arrangements for solid geometry"
/// (2016): the surfaces are divided where they meet, and what stays is the border of all that they
/// wind round once or more, by exact winding numbers.
#pragma once

#include <cstdint>

#include "mesh/healing/heal_act.h"

namespace tetfarm {

/// Where every edge has as many triangles one way as the other once each shell agrees on a side,
/// and some triangles meet beyond common corners and edges: the border of the union takes their
/// place. Shells that meet themselves or others are taken to face outward, as are those that lie in
/// nothing; one that lies inside others and meets none is a cavity if it faces inward, and gone as
/// a part of them if it faces outward. All of that is turned round where the shells together
/// enclose a negative volume. Triangles and vertices that meet nothing stay as they are. The number
/// of shells that were united or removed; 0, and nothing done, where rounding finds no end, or too
/// much meets (arrange_triangles). Deterministic. Cost: as arrange_triangles, and for each shell
/// the triangles along a ray.
std::int64_t unite_bodies(HealingWork& work);

}  // namespace tetfarm
