/// Polygons with whole-numbered corners, on which every test of direction is exact.
///
/// Loops are anticlockwise unless said otherwise. Coordinates are at most 2^28 in size, so that
/// twice the area of a triangle fits into 64 bits.
#pragma once

#include <cstdint>
#include <vector>

#include "tests/support/chance.h"

namespace tetfarm::shapes {

struct GridPoint {
  std::int64_t x = 0;
  std::int64_t y = 0;
  friend bool operator==(const GridPoint&, const GridPoint&) = default;
  friend GridPoint operator+(GridPoint a, GridPoint b) { return {a.x + b.x, a.y + b.y}; }
  friend GridPoint operator-(GridPoint a, GridPoint b) { return {a.x - b.x, a.y - b.y}; }
  friend GridPoint operator*(std::int64_t s, GridPoint a) { return {s * a.x, s * a.y}; }
};

/// Corners of a closed path; its sides neither cross nor touch each other but at common corners.
using Loop = std::vector<GridPoint>;

/// Twice the area of abc: positive when they turn anticlockwise.
inline std::int64_t turn(GridPoint a, GridPoint b, GridPoint c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Whether the closed segments ab and cd have a point in common.
bool segments_touch(GridPoint a, GridPoint b, GridPoint c, GridPoint d);

/// Corners near a circle round the origin, which sees all of them; strictly convex when
/// n^2 < 4 radius. @pre 3 <= n < radius.
Loop circle(int n, std::int64_t radius);

Loop rectangle(GridPoint low, GridPoint high);

Loop moved(Loop loop, GridPoint by);

/// The other way round.
Loop reversed(Loop loop);

/// A path that sees its middle, the origin, and has `n` corners between the two radii by chance.
/// @pre n < least radius / 4, n >= 3.
Loop star_loop(int n, std::int64_t least, std::int64_t most, Chance& chance);

}  // namespace tetfarm::shapes
