/// Divides prisms and pyramids of layers into tets so that neighbours agree on the diagonal of the
/// quad between them without knowing each other.
///
/// Source: thesis fig. 97, whose table of three tets is one of these. There neighbours agree by the
/// order of their nodes too. Each quad lies between two lines, from a level to the next: its
/// diagonal starts at the lower level of the line that comes first.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "mesh/layers/layer_plan.h"

namespace tetfarm {

/// The place of a line among all, which every chunk that has it sees alike.
using LineOrder = std::array<std::int64_t, 3>;

/// By its foot, then by the vertex of the surface at its top, or else by the top's number among
/// those that are none (ChunkLine::top). @pre it has layers.
LineOrder order_of(const LayerLine& line, std::uint32_t top);

/// By the nodes of the prism in the order of elements.h, of which the first three are nearer to
/// the wall. @pre `order`, numbers that tell the order of the lines of these three, differ.
std::array<std::array<std::uint8_t, 4>, 3> tets_of_prism(const std::array<std::int32_t, 3>& order);

/// By the nodes of the pyramid in the order of elements.h. @pre corner < 4: at which corner of the
/// base the diagonal starts or ends.
std::array<std::array<std::uint8_t, 4>, 2> tets_of_pyramid(std::size_t corner);

}  // namespace tetfarm
