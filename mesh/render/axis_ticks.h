/// Round numbers along an axis, and how they are written.
#pragma once

#include <string>
#include <vector>

namespace tetfarm {

struct AxisTick {
  double value = 0;
  std::string text;  ///< "0.25", "-40", "1.5e-7": exactly the value
};

/// The multiples of a step of 1, 2 or 5 times a power of ten from low to high, of the smallest
/// step that gives at most so many. One alone, rounded, where double numbers cannot tell more
/// apart. @pre finite, low <= high, most > 0
std::vector<AxisTick> axis_ticks(double low, double high, int most);

}  // namespace tetfarm
