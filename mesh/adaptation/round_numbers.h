/// Round numbers in place of fitted ones: a radius of 20.000003 that nodes leave open is 20.
#pragma once

#include <array>
#include <cmath>

namespace tetfarm {

/// How coarsely numbers about as large as `size` are rounded, one after another: to 2 to 6 digits
/// behind the first. As the reciprocals of the steps where these are below 1, negative: see
/// rounded_to. @pre size > 0 and finite
std::array<double, 5> round_steps(double size);

/// The multiple of the step next to the value. A negative step is minus the reciprocal of one, for
/// then the result is the decimal number itself.
inline double rounded_to(double value, double step) {
  const double rounded =
      step < 0 ? std::round(value * -step) / -step : std::round(value / step) * step;
  return rounded + 0.0;  // no -0
}

/// Whether rounding keeps all nodes nearly as near as the fit does: errors of one sign, such as
/// those of splines beside a circle, let it lie up to twice as far off.
inline bool is_as_good(double off, double off_by_fit, double size) {
  return off <= 2.5 * off_by_fit + 1e-13 * size;
}

}  // namespace tetfarm
