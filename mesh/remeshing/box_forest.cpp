#include "mesh/remeshing/box_forest.h"

#include <algorithm>
#include <numeric>

#include "base/check.h"
#include "mesh/geometry/box_measures.h"
#include "mesh/geometry/median_split.h"

namespace tetfarm {
namespace {

constexpr std::int32_t items_in_leaf = 4;

}  // namespace

BoxForest::BoxForest(std::span<const Box3> boxes, std::span<const std::int32_t> group,
                     std::int32_t group_count)
    : items_(boxes.size()), roots_(static_cast<std::size_t>(group_count), -1) {
  TF_CHECK(boxes.size() == group.size());
  std::iota(items_.begin(), items_.end(), 0);
  const auto group_of = [group](std::int32_t item) {
    return group[static_cast<std::size_t>(item)];
  };
  std::ranges::stable_sort(items_, {}, group_of);
  nodes_.reserve(boxes.size());
  for (std::size_t begin = 0; begin < items_.size();) {
    const std::int32_t of = group_of(items_[begin]);
    std::size_t end = begin;
    while (end < items_.size() && group_of(items_[end]) == of) ++end;
    roots_[static_cast<std::size_t>(of)] = static_cast<std::int32_t>(nodes_.size());
    build(boxes, static_cast<std::int32_t>(begin), static_cast<std::int32_t>(end));
    begin = end;
  }
}

void BoxForest::build(std::span<const Box3> boxes, std::int32_t first, std::int32_t last) {
  const auto box_of = [boxes](std::int32_t item) -> const Box3& {
    return boxes[static_cast<std::size_t>(item)];
  };
  const auto here = nodes_.size();
  Node node;
  for (std::int32_t k = first; k < last; ++k)
    node.box.add(box_of(items_[static_cast<std::size_t>(k)]));
  if (last - first <= items_in_leaf) {
    std::sort(items_.begin() + first, items_.begin() + last);
    node.first = first;
    node.count = last - first;
    nodes_.push_back(node);
    return;
  }
  nodes_.push_back(node);
  const std::span items{items_.begin() + first, items_.begin() + last};
  const std::size_t half = split_at_median(items, boxes, longest_axis(node.box));
  const std::int32_t middle = first + static_cast<std::int32_t>(half);
  build(boxes, first, middle);
  nodes_[here].right = static_cast<std::int32_t>(nodes_.size());
  build(boxes, middle, last);
}

}  // namespace tetfarm
