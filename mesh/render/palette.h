/// Colours that tell many things apart, the same number always in the same colour.
#pragma once

#include <cstdint>

#include "mesh/render/picture.h"

namespace tetfarm {

/// Light and not too strong, so that edges and shades show on them. Neighbouring numbers differ
/// much: the hue goes on by the golden section of the circle.
Colour palette_colour(std::int32_t number);

/// Strong ones, for lines on light ground; people of any colour vision tell the first six apart by
/// hue or lightness. After the last they start again.
Colour line_colour(std::int32_t number);

/// That of a cell of the layer, counted from 1: neighbouring layers differ.
/// @param is_absorbing of absorbing layers, not boundary layers.
Colour layer_colour(std::int32_t layer, bool is_absorbing);

/// Cells beyond all layers.
inline constexpr Colour beyond_layers{0.74F, 0.83F, 0.91F};

/// What bodies and walls are drawn in.
inline constexpr Colour neutral_grey{0.78F, 0.79F, 0.81F};

}  // namespace tetfarm
