#include "tests/support/grid_polygon.h"

#include <algorithm>
#include <numbers>

namespace tetfarm::shapes {
namespace {

int sign(std::int64_t x) { return (x > 0 ? 1 : 0) - (x < 0 ? 1 : 0); }

bool is_between(GridPoint a, GridPoint b, GridPoint p) {
  return std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) && std::min(a.y, b.y) <= p.y &&
         p.y <= std::max(a.y, b.y);
}

GridPoint on_circle(int k, int n, std::int64_t radius) {
  const double angle = 2 * std::numbers::pi * k / n;
  const auto r = static_cast<double>(radius);
  return {std::llround(r * std::cos(angle)), std::llround(r * std::sin(angle))};
}

}  // namespace

bool segments_touch(GridPoint a, GridPoint b, GridPoint c, GridPoint d) {
  if (std::max(a.x, b.x) < std::min(c.x, d.x) || std::max(c.x, d.x) < std::min(a.x, b.x) ||
      std::max(a.y, b.y) < std::min(c.y, d.y) || std::max(c.y, d.y) < std::min(a.y, b.y)) {
    return false;
  }
  const int abc = sign(turn(a, b, c)), abd = sign(turn(a, b, d));
  const int cda = sign(turn(c, d, a)), cdb = sign(turn(c, d, b));
  if (abc * abd < 0 && cda * cdb < 0) return true;
  return (abc == 0 && is_between(a, b, c)) || (abd == 0 && is_between(a, b, d)) ||
         (cda == 0 && is_between(c, d, a)) || (cdb == 0 && is_between(c, d, b));
}

Loop circle(int n, std::int64_t radius) {
  Loop loop;
  for (int k = 0; k < n; ++k) loop.push_back(on_circle(k, n, radius));
  return loop;
}

Loop rectangle(GridPoint low, GridPoint high) {
  return {low, {high.x, low.y}, high, {low.x, high.y}};
}

Loop moved(Loop loop, GridPoint by) {
  for (GridPoint& p : loop) p = p + by;
  return loop;
}

Loop reversed(Loop loop) {
  std::reverse(loop.begin(), loop.end());
  return loop;
}

Loop star_loop(int n, std::int64_t least, std::int64_t most, Chance& chance) {
  Loop loop;
  for (int k = 0; k < n; ++k) {
    const double share = chance.between(0, 1);
    const auto radius =
        least + static_cast<std::int64_t>(share * static_cast<double>(most - least));
    loop.push_back(on_circle(k, n, radius));
  }
  return loop;
}

}  // namespace tetfarm::shapes
