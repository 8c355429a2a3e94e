#include "mesh/geometry/box_tree.h"

#include <numeric>

#include "base/check.h"
#include "mesh/geometry/box_measures.h"

namespace tetfarm {
namespace {

constexpr std::int32_t leaf_size = 4;

}  // namespace

BoxTree::BoxTree(std::span<const Box3> boxes) : items_(boxes.size()) {
  TF_CHECK(boxes.size() <= std::numeric_limits<std::int32_t>::max());
  for (const Box3& box : boxes) {
    TF_CHECK(box.low.x <= box.high.x && box.low.y <= box.high.y && box.low.z <= box.high.z);
  }
  if (boxes.empty()) return;
  std::iota(items_.begin(), items_.end(), 0);
  build(boxes, 0, static_cast<std::int32_t>(boxes.size()));
  item_boxes_.reserve(boxes.size());
  for (const std::int32_t i : items_) item_boxes_.push_back(boxes[static_cast<std::size_t>(i)]);
}

void BoxTree::build(std::span<const Box3> boxes, std::int32_t first, std::int32_t last) {
  TF_CHECK(first < last);
  const auto box_of = [&boxes](std::int32_t i) -> const Box3& {
    return boxes[static_cast<std::size_t>(i)];
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
  // Ties are broken by number, so that the two halves do not depend on how nth_element works.
  const int axis = longest_axis(centres);
  const std::int32_t middle = first + (last - first) / 2;
  std::nth_element(begin, items_.begin() + middle, end, [&](std::int32_t a, std::int32_t b) {
    const double ca = box_of(a).low[axis] + box_of(a).high[axis];
    const double cb = box_of(b).low[axis] + box_of(b).high[axis];
    return ca < cb || (ca == cb && a < b);
  });
  build(boxes, first, middle);
  nodes_[self].right = static_cast<std::int32_t>(nodes_.size());
  build(boxes, middle, last);
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
