#include "mesh/shapes/circle_point.h"

#include "base/check.h"

namespace tetfarm {
namespace {

constexpr double eighth_turn = 0x1.921fb54442d18p-1;

/// @pre 0 <= x <= pi/4.
CirclePoint by_series(double x) {
  TF_CHECK(x >= 0 && x <= eighth_turn);
  const double x2 = x * x;
  double cosine = 1;
  double sine = 1;
  for (int n = 18; n > 0; n -= 2) {
    cosine = 1 - x2 / ((n - 1) * n) * cosine;
    sine = 1 - x2 / (n * (n + 1)) * sine;
  }
  return {cosine, x * sine};
}

}  // namespace

CirclePoint circle_point(std::int64_t k, std::int64_t n) {
  TF_CHECK(n > 0);
  const std::int64_t eighths = 8 * ((k % n + n) % n);
  const std::int64_t octant = eighths / n;
  const std::int64_t rest = eighths % n;
  const bool falling = octant % 2 == 1;
  const double part = static_cast<double>(falling ? n - rest : rest) / static_cast<double>(n);
  const auto [c, s] = by_series(eighth_turn * part);
  switch (octant) {
    case 0:
      return {c, s};
    case 1:
      return {s, c};
    case 2:
      return {0 - s, c};
    case 3:
      return {-c, s};
    case 4:
      return {-c, 0 - s};
    case 5:
      return {0 - s, -c};
    case 6:
      return {s, -c};
    default:
      return {c, 0 - s};
  }
}

}  // namespace tetfarm
