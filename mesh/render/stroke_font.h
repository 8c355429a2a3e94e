/// Words as lines, for the numbers and names in pictures: digits, signs, and small letters.
///
/// The letters are this project's own: straight lines, and quadratic B-splines through few points
/// on a grid. Coordinates as of PlaneCanvas.
#pragma once

#include <string_view>
#include <vector>

#include "mesh/render/plane_canvas.h"

namespace tetfarm {

/// `height`: of a digit, in pixels. A letter that there is none of leaves a gap.
double text_width(std::string_view text, double height);

/// With the lower left corner of the first digit at `at`; as wide as text_width says.
std::vector<Stroke> text_strokes(std::string_view text, const Vec2& at, double height);

}  // namespace tetfarm
