#include "mesh/decompose/shadow_grid.h"

#include <algorithm>
#include <cmath>

namespace tetfarm {

ShadowGrid::ShadowGrid(std::span<const Box3> boxes) : boxes_(boxes.begin(), boxes.end()) {
  constexpr double most_cells_per_axis = 256;
  Box3 all;
  for (const Box3& box : boxes) all.add(box);
  size_ = static_cast<int>(
      std::clamp(std::sqrt(static_cast<double>(boxes.size())), 1.0, most_cells_per_axis));
  if (!boxes.empty()) {
    low_ = all.low;
    for (const int axis : {1, 2}) {
      const double extent = all.high[axis] - all.low[axis];
      per_cell_[axis] = extent > 0 ? size_ / extent : 0;
    }
  }
  const auto for_each_cell = [this](const Box3& box, auto&& visit) {
    for (int j = index_on(1, box.low.y); j <= index_on(1, box.high.y); ++j) {
      for (int k = index_on(2, box.low.z); k <= index_on(2, box.high.z); ++k) visit(cell(j, k));
    }
  };
  first_.assign(static_cast<std::size_t>(size_) * static_cast<std::size_t>(size_) + 1, 0);
  for (const Box3& box : boxes_) {
    for_each_cell(box, [this](std::size_t c) { ++first_[c + 1]; });
  }
  for (std::size_t c = 1; c < first_.size(); ++c) first_[c] += first_[c - 1];
  items_.resize(static_cast<std::size_t>(first_.back()));
  std::vector<std::int32_t> next(first_.begin(), first_.end() - 1);
  for (std::size_t i = 0; i < boxes_.size(); ++i) {
    for_each_cell(boxes_[i], [&](std::size_t c) {
      items_[static_cast<std::size_t>(next[c]++)] = static_cast<std::int32_t>(i);
    });
  }
}

}  // namespace tetfarm
