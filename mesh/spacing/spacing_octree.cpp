#include "mesh/spacing/spacing_octree.h"

#include <algorithm>
#include <cmath>

namespace tetfarm {
namespace {

/// Checks the sub-tree in Morton order; `leaf` counts the leaves met.
bool children_are_sound(const SpacingOctree& octree, std::size_t node, int level,
                        std::int32_t& leaf, std::size_t& nodes) {
  ++nodes;
  const std::int32_t child = octree.child_of[node];
  if (child < 0) {
    if (~child != leaf || leaf >= octree.leaf_count()) return false;
    const int lattice_level = octree.lattice_level[static_cast<std::size_t>(leaf)];
    ++leaf;
    return lattice_level >= level && lattice_level <= octree_max_level;
  }
  const auto first = static_cast<std::size_t>(child);
  if (level == octree_max_level || first == 0 || first + 8 > octree.child_of.size()) return false;
  for (std::size_t k = 0; k < 8; ++k) {
    if (nodes >= octree.child_of.size()) return false;
    if (!children_are_sound(octree, first + k, level + 1, leaf, nodes)) return false;
  }
  return true;
}

/// A point in half-units, moved into the root where it lies outside, and the grid point below it.
struct PlaceInGrid {
  std::array<double, 3> exact{};
  GridPoint floor{};
};

PlaceInGrid place_in(const GridFrame& frame, const Vec3& point) {
  const double per_unit = 1 / frame.unit;
  PlaceInGrid place;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double x = (point[static_cast<int>(axis)] - frame.coordinate(axis, 0)) * per_unit;
    place.exact[axis] = x > 0 ? std::min(x, static_cast<double>(octree_span)) : 0.0;
    place.floor[axis] = std::min(static_cast<std::int32_t>(place.exact[axis]), octree_span - 1);
  }
  return place;
}

}  // namespace

double SpacingOctree::at(const Vec3& point) const {
  const auto [u, cell] = place_in(frame, point);
  std::int32_t child = child_of[0];
  int shift = octree_max_level;
  for (; child >= 0; --shift) {
    child = child_of[static_cast<std::size_t>(child) + child_number(cell, shift)];
  }
  const std::int32_t size = std::int32_t{1} << (shift + 1);
  const double per_size = 1.0 / size;
  std::array<double, 3> t{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    t[axis] = (u[axis] - (cell[axis] & ~(size - 1))) * per_size;
  }
  const std::array<float, 8>& v = values[static_cast<std::size_t>(~child)];
  const auto mix = [](double a, double b, double s) { return a + (b - a) * s; };
  const double low = mix(mix(v[0], v[1], t[0]), mix(v[2], v[3], t[0]), t[1]);
  const double high = mix(mix(v[4], v[5], t[0]), mix(v[6], v[7], t[0]), t[1]);
  return mix(low, high, t[2]);
}

double SpacingOctree::lattice_cell_edge(const Vec3& point) const {
  const LeafAt found = leaf_at(child_of, place_in(frame, point).floor);
  return size_at_level(lattice_level[static_cast<std::size_t>(found.leaf)]) * frame.unit;
}

const char* validate(const SpacingOctree& octree) {
  const std::size_t leaves = octree.lattice_level.size();
  if (octree.child_of.empty()) return "no node";
  if (octree.values.size() != leaves || octree.owned_corners.size() != leaves) return "lengths";
  const GridFrame& frame = octree.frame;
  if (!(frame.unit > 0) || !std::isfinite(frame.unit)) return "unit";
  for (const std::int64_t low : frame.low) {
    if (low > GridFrame::farthest || low < -GridFrame::farthest) return "low corner";
  }
  std::int32_t leaf = 0;
  std::size_t nodes = 0;
  if (!children_are_sound(octree, 0, 0, leaf, nodes) || leaf != octree.leaf_count() ||
      nodes != octree.child_of.size()) {
    return "tree";
  }
  for (const auto& corners : octree.values) {
    for (const float value : corners) {
      if (!(value > 0) || !std::isfinite(value)) return "value";
    }
  }
  return nullptr;
}

LeafAt leaf_at(std::span<const std::int32_t> child_of, const GridPoint& p) {
  LeafAt found;
  std::int32_t child = child_of[0];
  for (; child >= 0; ++found.cell.level) {
    const int shift = octree_max_level - found.cell.level;
    child = child_of[static_cast<std::size_t>(child) + child_number(p, shift)];
  }
  found.leaf = ~child;
  const std::int32_t mask = ~(size_at_level(found.cell.level) - 1);
  found.cell.low = {p[0] & mask, p[1] & mask, p[2] & mask};
  return found;
}

LatticeCell lattice_cell_at(const SpacingOctree& octree, const GridPoint& p) {
  const LeafAt found = leaf_at(octree.child_of, p);
  const int level = octree.lattice_level[static_cast<std::size_t>(found.leaf)];
  if (level <= found.cell.level) return found.cell;
  const std::int32_t mask = ~(size_at_level(level) - 1);
  return {level, {p[0] & mask, p[1] & mask, p[2] & mask}};
}

LatticeCell owner_of(const SpacingOctree& octree, const GridPoint& node) {
  LatticeCell owner{-1, {}};
  for (std::size_t k = 0; k < 8; ++k) {
    // The cell that counts the node as its corner k holds the smallest cell on the other side.
    GridPoint p = node;
    for (std::size_t axis = 0; axis < 3; ++axis) p[axis] -= static_cast<int>((k >> axis) & 1U);
    if (std::ranges::any_of(p, [](std::int32_t i) { return i < 0 || i >= octree_span; })) continue;
    const LatticeCell cell = lattice_cell_at(octree, p);
    if (cell.level <= owner.level) continue;
    if (corner_of(cell.low, size_at_level(cell.level), k) == node) owner = cell;
  }
  return owner;
}

}  // namespace tetfarm
