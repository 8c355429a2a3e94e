#include "mesh/half_body/nested_loops.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "base/check.h"

namespace tetfarm {
namespace {

struct Box2 {
  Vec2 low{HUGE_VAL, HUGE_VAL};
  Vec2 high{-HUGE_VAL, -HUGE_VAL};

  bool contains(const Vec2& p) const {
    return low.x <= p.x && p.x <= high.x && low.y <= p.y && p.y <= high.y;
  }
};

Box2 box_of_loop(const std::vector<Vec2>& loop) {
  Box2 box;
  for (const Vec2& p : loop) {
    box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y)};
    box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y)};
  }
  return box;
}

bool is_left_of(const Vec2& a, const Vec2& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; }

std::size_t leftmost(const std::vector<Vec2>& loop) {
  return static_cast<std::size_t>(std::min_element(loop.begin(), loop.end(), is_left_of) -
                                  loop.begin());
}

/// Whether it turns anticlockwise: exact, from the loop's leftmost point, the lowest of several,
/// where it does not turn back on itself.
bool is_anticlockwise(const std::vector<Vec2>& loop) {
  const std::size_t n = loop.size();
  const std::size_t i = leftmost(loop);
  const double turn = orient2d(loop[(i + n - 1) % n], loop[i], loop[(i + 1) % n]);
  return turn != 0 ? turn > 0 : twice_area(loop) > 0;
}

/// By the edges that a ray to the left meets; a point at the ray's height counts as above it.
bool is_inside(const Vec2& p, const std::vector<Vec2>& loop) {
  bool inside = false;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Vec2& a = loop[i];
    const Vec2& b = loop[(i + 1) % loop.size()];
    if ((a.y < p.y) == (b.y < p.y)) continue;
    const Vec2& lower = a.y < b.y ? a : b;
    const Vec2& upper = a.y < b.y ? b : a;
    if (orient2d(lower, upper, p) < 0) inside = !inside;
  }
  return inside;
}

}  // namespace

double twice_area(const std::vector<Vec2>& loop) {
  double sum = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Vec2& a = loop[i];
    const Vec2& b = loop[(i + 1) % loop.size()];
    sum += (a.x - loop[0].x) * (b.y - loop[0].y) - (b.x - loop[0].x) * (a.y - loop[0].y);
  }
  return sum;
}

std::vector<bool> turned_loops(const std::vector<std::vector<Vec2>>& loops) {
  std::vector<Box2> boxes;
  for (const std::vector<Vec2>& loop : loops) {
    TF_CHECK(loop.size() >= 3);
    boxes.push_back(box_of_loop(loop));
  }
  std::vector<bool> is_turned;
  for (std::size_t i = 0; i < loops.size(); ++i) {
    const Vec2 point = loops[i][leftmost(loops[i])];
    bool is_hole = false;
    for (std::size_t other = 0; other < loops.size(); ++other) {
      if (other == i || !boxes[other].contains(point)) continue;
      if (is_inside(point, loops[other])) is_hole = !is_hole;
    }
    is_turned.push_back(is_anticlockwise(loops[i]) == is_hole);
  }
  return is_turned;
}

}  // namespace tetfarm
