#include "mesh/spacing/level_shift.h"

#include <algorithm>

#include "base/check.h"

namespace tetfarm {
namespace {

/// For each larger cell at a corner, in 1/128 of the smaller cell's edge along each axis. By the
/// corner's place on the larger cell: its corner, the middle of an edge, the middle of a face.
constexpr std::array<int, 3> steps_of_place = {7, 5, 5};

int lattice_level_at(const SpacingOctree& octree, const GridPoint& p) {
  const LeafAt found = leaf_at(octree.child_of, p);
  return std::max<int>(found.cell.level,
                       octree.lattice_level[static_cast<std::size_t>(found.leaf)]);
}

}  // namespace

std::array<std::int8_t, 3> shift_to_coarser(const SpacingOctree& octree, const GridPoint& corner,
                                            int level) {
  TF_CHECK(level >= 0 && level <= octree_max_level);
  GridPoint towards{};
  std::size_t odd_axes = 0;
  for (const std::int32_t i : corner) {
    odd_axes += static_cast<std::size_t>((i / size_at_level(level)) & 1);
  }
  // The middle of a larger cell, were it one: no larger cell touches it.
  if (odd_axes == steps_of_place.size()) return {};
  for (std::size_t k = 0; k < 8; ++k) {
    GridPoint p = corner;
    for (std::size_t axis = 0; axis < 3; ++axis) p[axis] -= static_cast<int>((k >> axis) & 1U);
    if (std::ranges::any_of(p, [](std::int32_t i) { return i < 0 || i >= octree_span; })) continue;
    if (lattice_level_at(octree, p) >= level) continue;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      towards[axis] += ((k >> axis) & 1U) != 0 ? -1 : 1;
    }
  }
  std::array<std::int8_t, 3> shift{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    shift[axis] = static_cast<std::int8_t>(steps_of_place[odd_axes] * towards[axis]);
  }
  return shift;
}

}  // namespace tetfarm
