/// A plane of constant x, y or z.
#pragma once

#include <string>

namespace tetfarm {

/// All points whose coordinate number `axis` is `height`.
struct AxisPlane {
  int axis = 0;
  double height = 0;

  /// "y=0".
  std::string text() const;

  friend bool operator==(const AxisPlane&, const AxisPlane&) = default;
};

}  // namespace tetfarm
