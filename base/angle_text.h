/// Angles in messages, with as many digits as tell a small one from none.
#pragma once

#include <string>

namespace tetfarm {

/// "24.31", "0.0021", "179.9979", "0.00022": so many decimals, and near 0 and 180 so many more that
/// two digits of the difference are left, at most nine. "0" and "180" only when it is exactly that.
/// @param deg degrees, 0 to 180; others are written plainly.
std::string angle_text(double deg, int decimals = 2);

}  // namespace tetfarm
