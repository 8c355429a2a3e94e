#include "mesh/geometry/box_tree.h"

#include <limits>
#include <numeric>
#include <utility>

#include "base/check.h"
#include "mesh/geometry/box_measures.h"
#include "mesh/geometry/median_split.h"

namespace tetfarm {
namespace {

constexpr std::int32_t leaf_size = 4;

}  // namespace

BoxTree::BoxTree(std::vector<Box3> boxes) : items_(boxes.size()), item_boxes_(std::move(boxes)) {
  TF_CHECK(item_boxes_.size() <= std::numeric_limits<std::int32_t>::max());
  for (const Box3& box : item_boxes_) {
    TF_CHECK(box.low.x <= box.high.x && box.low.y <= box.high.y && box.low.z <= box.high.z);
  }
  if (items_.empty()) return;
  std::iota(items_.begin(), items_.end(), 0);
  build(0, static_cast<std::int32_t>(items_.size()));
  put_boxes_in_order();
}

/// In place: round each cycle of the permutation.
void BoxTree::put_boxes_in_order() {
  std::vector<bool> is_placed(items_.size(), false);
  for (std::size_t start = 0; start < items_.size(); ++start) {
    if (is_placed[start]) continue;
    const Box3 first = item_boxes_[start];
    std::size_t to = start;
    for (;;) {
      is_placed[to] = true;
      const auto from = static_cast<std::size_t>(items_[to]);
      if (from == start) break;
      item_boxes_[to] = item_boxes_[from];
      to = from;
    }
    item_boxes_[to] = first;
  }
}

/// The boxes are in their own order still.
void BoxTree::build(std::int32_t first, std::int32_t last) {
  TF_CHECK(first < last);
  const auto box_of = [this](std::int32_t i) -> const Box3& {
    return item_boxes_[static_cast<std::size_t>(i)];
  };
  const auto begin = items_.begin() + first;
  const auto end = items_.begin() + last;
  const std::size_t self = nodes_.size();
  nodes_.emplace_back();
  Box3 hull;
  Box3 centres;
  for (auto it = begin; it != end; ++it) {
    hull.add(box_of(*it));
    centres.add(box_of(*it).centre());
  }
  nodes_[self].box = hull;
  if (last - first <= leaf_size) {
    std::sort(begin, end);
    nodes_[self].first = first;
    nodes_[self].count = last - first;
    return;
  }
  const std::size_t half = split_at_median({begin, end}, item_boxes_, longest_axis(centres));
  const std::int32_t middle = first + static_cast<std::int32_t>(half);
  build(first, middle);
  nodes_[self].right = static_cast<std::int32_t>(nodes_.size());
  build(middle, last);
}

std::vector<Box3> triangle_boxes(std::span<const Vec3> vertices,
                                 std::span<const Triangle> triangles) {
  std::vector<Box3> boxes(triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (const std::int32_t v : triangles[t]) {
      TF_CHECK(v >= 0 && static_cast<std::size_t>(v) < vertices.size());
      boxes[t].add(vertices[static_cast<std::size_t>(v)]);
    }
  }
  return boxes;
}

}  // namespace tetfarm
