#include "mesh/layers/side_triangles.h"

#include <algorithm>

#include "mesh/layers/prism_division.h"

namespace tetfarm {
namespace {

/// Levels that both lines have, above the first.
int common_layers(const LineSide& side) {
  return std::max(0, std::min(side.from.stop, side.to.stop) - side.first_level);
}

SideNode from_at(int level) { return {0, level}; }
SideNode to_at(int level) { return {1, level}; }

/// Whether the diagonals start at the line that the side runs from.
bool starts_at_from(const LineSide& side) {
  if (side.from.early != side.to.early) return side.to.early;
  return order_of(side.from, 0) < order_of(side.to, 0);
}

}  // namespace

bool is_divided(const LineSide& side) {
  return (side.from.in_tets && side.to.in_tets) || side.from.early != side.to.early;
}

int quads_of(const LineSide& side) { return is_divided(side) ? 0 : common_layers(side); }

std::vector<SideTriangle> triangles_of(const LineSide& side) {
  std::vector<SideTriangle> triangles;
  const int common = is_divided(side) ? common_layers(side) : 0;
  const bool is_from_first = common > 0 && starts_at_from(side);
  for (int low = side.first_level; low < side.first_level + common; ++low) {
    const int high = low + 1;
    if (is_from_first) {
      triangles.push_back({from_at(low), to_at(low), to_at(high)});
      triangles.push_back({from_at(low), to_at(high), from_at(high)});
    } else {
      triangles.push_back({from_at(low), to_at(low), from_at(high)});
      triangles.push_back({to_at(low), to_at(high), from_at(high)});
    }
  }
  const int both = std::min(side.from.stop, side.to.stop);
  for (int level = both; level < side.from.stop; ++level) {
    triangles.push_back({from_at(level), to_at(both), from_at(level + 1)});
  }
  for (int level = both; level < side.to.stop; ++level) {
    triangles.push_back({from_at(both), to_at(level), to_at(level + 1)});
  }
  return triangles;
}

}  // namespace tetfarm
