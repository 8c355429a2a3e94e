/// Points of the unit circle by one fixed sequence of + - * /, the same bits on every machine.
///
/// libm's sine differs between machines. Source: reduction to an eighth of the circle, then the
/// Taylor series.
#pragma once

#include <cstdint>

namespace tetfarm {

struct CirclePoint {
  double cosine = 1;
  double sine = 0;
};

/// Cosine and sine of k/n of a full turn, error below 3e-16. Exact at the quarters, and points that
/// mirror each other do so bit by bit. @pre 0 < n < 2^59, |k| < 2^59. Cost: some 40 flops.
CirclePoint circle_point(std::int64_t k, std::int64_t n);

}  // namespace tetfarm
