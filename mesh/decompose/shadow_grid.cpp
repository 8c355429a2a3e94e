#include "mesh/decompose/shadow_grid.h"

#include <algorithm>
#include <cmath>

namespace tetfarm {

ShadowGrid::ShadowGrid(std::span<const Box3> boxes) {
  constexpr double most_cells_per_axis = 256;
  Box3 all;
  for (const Box3& box : boxes) all.add(box);
  if (!boxes.empty()) {
    low_ = all.low;
    const auto count = static_cast<double>(boxes.size());
    for (const int axis : {1, 2}) {
      const double extent = all.high[axis] - all.low[axis];
      double widths = 0;
      for (const Box3& box : boxes) widths += box.high[axis] - box.low[axis];
      // Cells smaller than the boxes would hold each box many times.
      const double useful =
          widths > 0 ? std::min(std::sqrt(count), extent * count / widths) : std::sqrt(count);
      const int size = static_cast<int>(std::clamp(useful, 1.0, most_cells_per_axis));
      size_[static_cast<std::size_t>(axis)] = size;
      per_cell_[axis] = extent > 0 ? size / extent : 0;
    }
  }
  const auto for_each_cell = [this](const Box3& box, auto&& visit) {
    for (int j = index_on(1, box.low.y); j <= index_on(1, box.high.y); ++j) {
      for (int k = index_on(2, box.low.z); k <= index_on(2, box.high.z); ++k) visit(cell(j, k));
    }
  };
  first_.assign(cell(size_[1] - 1, size_[2] - 1) + 2, 0);
  for (const Box3& box : boxes) {
    for_each_cell(box, [this](std::size_t c) { ++first_[c + 1]; });
  }
  for (std::size_t c = 1; c < first_.size(); ++c) first_[c] += first_[c - 1];
  items_.resize(static_cast<std::size_t>(first_.back()));
  std::vector<std::int32_t> next(first_.begin(), first_.end() - 1);
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const Box3& box = boxes[i];
    const Item item{box.low.y,
                    box.high.y,
                    box.low.z,
                    box.high.z,
                    static_cast<std::int32_t>(i),
                    static_cast<std::int16_t>(index_on(1, box.low.y)),
                    static_cast<std::int16_t>(index_on(2, box.low.z))};
    for_each_cell(box, [&](std::size_t c) { items_[static_cast<std::size_t>(next[c]++)] = item; });
  }
}

}  // namespace tetfarm
