/// Divides a prism of layers into three tets so that neighbours agree on the diagonal of the quad
/// between them without knowing each other.
///
/// Source: thesis fig. 97, whose table of three tets is one of these. There neighbours agree by the
/// order of their nodes too: of each side of the prism the diagonal starts at the wall, at the foot
/// of the lower number.
#pragma once

#include <array>
#include <cstdint>

namespace tetfarm {

/// By the nodes of the prism in the order of elements.h, of which the first three are nearer to
/// the wall. @pre `feet`, the numbers of the lines' feet in the order of these three, differ.
std::array<std::array<std::uint8_t, 4>, 3> tets_of_prism(const std::array<std::int32_t, 3>& feet);

}  // namespace tetfarm
