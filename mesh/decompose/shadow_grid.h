/// A grid over the (y, z) shadows of boxes: which of them lie on the same lines along x as another.
///
/// For a few thousand boxes asked for by very many small ones, where a box tree takes five times as
/// long. Cost: build O(boxes + cells they cover); a query O(boxes in the cells that it covers).
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/core/vec3.h"

namespace tetfarm {

class ShadowGrid {
 public:
  /// @pre no box is empty or holds a NaN.
  explicit ShadowGrid(std::span<const Box3> boxes);

  /// Calls visit(i) once for every box i whose shadow overlaps that of `box`.
  template <typename Visitor>
  void query(const Box3& box, Visitor&& visit) const;

 private:
  /// A row or column of the grid; outside of it, the nearest.
  int index_on(int axis, double x) const {
    const double i = (x - low_[axis]) * per_cell_[axis];
    const int last = size_[static_cast<std::size_t>(axis)] - 1;
    return i > 0 ? (i < last ? static_cast<int>(i) : last) : 0;
  }
  std::size_t cell(int j, int k) const {
    return static_cast<std::size_t>(j) * static_cast<std::size_t>(size_[2]) +
           static_cast<std::size_t>(k);
  }

  /// A box in a cell: side by side, as queries go through all of a cell.
  struct Item {
    double low_y = 0;
    double high_y = 0;
    double low_z = 0;
    double high_z = 0;
    std::int32_t number = 0;
    /// Of the first row and column of cells that it covers.
    std::int16_t first_j = 0;
    std::int16_t first_k = 0;
  };

  std::array<int, 3> size_{1, 1, 1};  // cells on each axis; x is not divided
  Vec3 low_;
  Vec3 per_cell_;
  std::vector<std::int32_t> first_;  // of each cell in items_, and the end of all
  std::vector<Item> items_;
};

template <typename Visitor>
void ShadowGrid::query(const Box3& box, Visitor&& visit) const {
  const Vec3 low = box.low;  // copies: visit may change anything else
  const Vec3 high = box.high;
  const int first_j = index_on(1, low.y);
  const int last_j = index_on(1, high.y);
  const int first_k = index_on(2, low.z);
  const int last_k = index_on(2, high.z);
  for (int j = first_j; j <= last_j; ++j) {
    for (int k = first_k; k <= last_k; ++k) {
      const std::size_t c = cell(j, k);
      const Item* const end = items_.data() + first_[c + 1];
      for (const Item* item = items_.data() + first_[c]; item != end; ++item) {
        if (item->low_y > high.y || low.y > item->high_y || item->low_z > high.z ||
            low.z > item->high_z) {
          continue;
        }
        // Both may share several cells: the first of them counts.
        const bool is_first =
            (j == first_j || item->first_j == j) && (k == first_k || item->first_k == k);
        if (is_first) visit(item->number);
      }
    }
  }
}

}  // namespace tetfarm
