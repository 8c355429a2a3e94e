/// Colours for the values of a field, from dark violet over teal to light yellow.
///
/// They differ by their lightness, which grows in even steps, so that people of any colour vision,
/// and prints without colour, show which of two values is larger. How the table was made: in
/// Oklab (B. Ottosson, 2020) the lightness goes evenly from 0.31 to 0.94 and the hue from 285 to
/// 105 degrees, with chroma 0.15 or, where a screen cannot show that, as much as it can.
#pragma once

#include "mesh/render/picture.h"

namespace tetfarm {

/// @param share from 0, dark, to 1, light; beyond them it is that of the end.
Colour map_colour(double share);

/// The bands of a contour plot: `count` of the same height between two values.
struct FieldLevels {
  double low = 0;
  double high = 1;
  int count = 20;

  /// From 0; values beyond the range count as of the last band on their side. Never falls as the
  /// value grows. @pre low < high and count > 0
  int level_of(double value) const;
  /// @pre 0 <= level < count
  Colour colour_of_level(int level) const;
  Colour colour_at(double value) const { return colour_of_level(level_of(value)); }
};

}  // namespace tetfarm
