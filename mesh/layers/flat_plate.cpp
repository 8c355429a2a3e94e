#include "mesh/layers/flat_plate.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"

namespace tetfarm {

double seventh_root(double x) {
  TF_CHECK(x > 0 && std::isfinite(x));
  // From above the steps only go down, so they end where rounding stops them.
  double root = std::max(1.0, x);
  while (true) {
    const double square = root * root;
    const double next = root - (root - x / (square * square * square)) / 7;
    if (!(next < root)) return root;
    root = next;
  }
}

FlatPlate flat_plate(double y_plus, double reynolds, double length) {
  TF_CHECK(y_plus > 0 && reynolds > 0 && length > 0);
  const double root = seventh_root(reynolds);
  FlatPlate plate;
  plate.skin_friction = 0.026 / root;
  plate.first_height = y_plus * length / (reynolds * std::sqrt(plate.skin_friction / 2));
  plate.thickness = 0.16 * length / root;
  return plate;
}

}  // namespace tetfarm
