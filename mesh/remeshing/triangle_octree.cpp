#include "mesh/remeshing/triangle_octree.h"

#include <algorithm>

#include "base/check.h"

namespace tetfarm {
namespace {

double longest_side(const Box3& box) {
  const Vec3 size = box.size();
  return std::max({size.x, size.y, size.z});
}

}  // namespace

TriangleOctree::TriangleOctree(const Box3& whole) {
  const double side = longest_side(whole);
  root_ = {whole.centre(), side > 0 ? 0.5 * side : 1};
}

std::int32_t TriangleOctree::cell_for(const Box3& box) {
  const double side = longest_side(box);
  const Vec3 middle = box.centre();
  std::int32_t cell = 0;
  Place place = root_;
  // A child's edge is the half of its parent.
  for (int level = 0; level < most_levels && place.half >= side; ++level) {
    const std::size_t child = (middle.x >= place.centre.x ? 1U : 0U) +
                              (middle.y >= place.centre.y ? 2U : 0U) +
                              (middle.z >= place.centre.z ? 4U : 0U);
    std::int32_t below = cells_[static_cast<std::size_t>(cell)].children[child];
    if (below < 0) {
      below = static_cast<std::int32_t>(cells_.size());
      cells_[static_cast<std::size_t>(cell)].children[child] = below;
      cells_.emplace_back().parent = cell;
    }
    cell = below;
    place = child_place(place, child);
  }
  // Rounding, and what lies outside the root: its cells do not hold it.
  if (!meets(place, box)) return 0;
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
  const std::int32_t cell = cell_for(box);
  if (cell == entry.cell) {
    entry.box = box;
    return;
  }
  remove(id);
  put(id, box, cell);
}

void TriangleOctree::put(std::int32_t id, const Box3& box, std::int32_t cell) {
  std::int32_t& first = cells_[static_cast<std::size_t>(cell)].first;
  entries_[static_cast<std::size_t>(id)] = {box, first, -1, cell};
  if (first >= 0) entries_[static_cast<std::size_t>(first)].previous = id;
  first = id;
  for (std::int32_t c = cell; c >= 0; c = cells_[static_cast<std::size_t>(c)].parent) {
    ++cells_[static_cast<std::size_t>(c)].count;
  }
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
  for (std::int32_t c = removed.cell; c >= 0; c = cells_[static_cast<std::size_t>(c)].parent) {
    --cells_[static_cast<std::size_t>(c)].count;
  }
  removed.cell = -1;
}

}  // namespace tetfarm
