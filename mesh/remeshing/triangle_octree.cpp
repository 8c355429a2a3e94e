#include "mesh/remeshing/triangle_octree.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"

namespace tetfarm {
namespace {

double longest_side(const Box3& box) {
  const Vec3 size = box.size();
  return std::max({size.x, size.y, size.z});
}

/// More than single precision rounds off.
constexpr float rounding_share = 1.0F / (1 << 22);

float rounded_down(double x) {
  const auto near = static_cast<float>(x);
  return near - rounding_share * std::fabs(near);
}

float rounded_up(double x) { return -rounded_down(-x); }

}  // namespace

TriangleOctree::TriangleOctree(const Box3& whole) {
  const double side = longest_side(whole);
  cells_[0].place = {whole.centre(), side > 0 ? 0.5 * side : 1};
}

TriangleOctree::RoughBox TriangleOctree::rough(const Box3& box) const {
  const Vec3 low = box.low - cells_[0].place.centre;
  const Vec3 high = box.high - cells_[0].place.centre;
  return {{rounded_down(low.x), rounded_down(low.y), rounded_down(low.z)},
          {rounded_up(high.x), rounded_up(high.y), rounded_up(high.z)}};
}

std::int32_t TriangleOctree::cell_for(const Box3& box) {
  const double side = longest_side(box);
  const Vec3 middle = box.centre();
  std::int32_t cell = 0;
  Place place = cells_[0].place;
  // A child's edge is the half of its parent.
  for (int level = 0; level < most_levels && place.half >= side; ++level) {
    const std::size_t child = (middle.x >= place.centre.x ? 1U : 0U) +
                              (middle.y >= place.centre.y ? 2U : 0U) +
                              (middle.z >= place.centre.z ? 4U : 0U);
    std::int32_t below = cells_[static_cast<std::size_t>(cell)].children[child];
    if (below < 0) {
      below = static_cast<std::int32_t>(cells_.size());
      cells_[static_cast<std::size_t>(cell)].children[child] = below;
      Cell& made = cells_.emplace_back();
      made.parent = cell;
      made.place = child_place(place, child);
    }
    cell = below;
    place = cells_[static_cast<std::size_t>(cell)].place;
  }
  // Rounding, and what lies outside the root: its cells do not hold it.
  if (!holds(place, box)) return 0;
  return cell;
}

void TriangleOctree::add(std::int32_t id, const Box3& box) {
  const auto at = static_cast<std::size_t>(id);
  if (at >= entries_.size()) entries_.resize(at + 1);
  TF_CHECK(entries_[at].cell < 0);
  put(id, box, cell_for(box));
}

void TriangleOctree::move(std::int32_t id, const Box3& box) {
  Entry& entry = entries_[static_cast<std::size_t>(id)];
  TF_CHECK(entry.cell >= 0);
  // The root has what no other cell holds.
  if (entry.cell > 0 && holds(cells_[static_cast<std::size_t>(entry.cell)].place, box)) {
    entry.box = rough(box);
    widen(entry.cell, entry.box);
    return;
  }
  remove(id);
  put(id, box, cell_for(box));
}

/// The hulls of the cell and of those above it hold the box.
void TriangleOctree::widen(std::int32_t cell, const RoughBox& box) {
  for (std::int32_t c = cell; c >= 0; c = cells_[static_cast<std::size_t>(c)].parent) {
    RoughBox& hull = cells_[static_cast<std::size_t>(c)].hull;
    if (hull.holds(box)) return;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      hull.low[axis] = std::min(hull.low[axis], box.low[axis]);
      hull.high[axis] = std::max(hull.high[axis], box.high[axis]);
    }
  }
}

void TriangleOctree::put(std::int32_t id, const Box3& box, std::int32_t cell) {
  std::int32_t& first = cells_[static_cast<std::size_t>(cell)].first;
  entries_[static_cast<std::size_t>(id)] = {rough(box), first, -1, cell};
  if (first >= 0) entries_[static_cast<std::size_t>(first)].previous = id;
  first = id;
  const RoughBox& made = entries_[static_cast<std::size_t>(id)].box;
  std::int32_t c = cell;
  for (; c >= 0; c = cells_[static_cast<std::size_t>(c)].parent) {
    Cell& above = cells_[static_cast<std::size_t>(c)];
    if (above.count++ > 0) break;
    above.hull = made;
  }
  widen(c, made);
}

void TriangleOctree::remove(std::int32_t id) {
  Entry& removed = entries_[static_cast<std::size_t>(id)];
  TF_CHECK(removed.cell >= 0);
  if (removed.previous >= 0) {
    entries_[static_cast<std::size_t>(removed.previous)].next = removed.next;
  } else {
    cells_[static_cast<std::size_t>(removed.cell)].first = removed.next;
  }
  if (removed.next >= 0)
    entries_[static_cast<std::size_t>(removed.next)].previous = removed.previous;
  for (std::int32_t c = removed.cell; c >= 0 && --cells_[static_cast<std::size_t>(c)].count == 0;
       c = cells_[static_cast<std::size_t>(c)].parent) {
  }
  removed.cell = -1;
}

}  // namespace tetfarm
