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

  std::vector<Box3> boxes_;
  std::array<int, 3> size_{1, 1, 1};  // cells on each axis; x is not divided
  Vec3 low_;
  Vec3 per_cell_;
  std::vector<std::int32_t> first_;  // of each cell in items_, and the end of all
  std::vector<std::int32_t> items_;
};

template <typename Visitor>
void ShadowGrid::query(const Box3& box, Visitor&& visit) const {
  const int first_j = index_on(1, box.low.y);
  const int last_j = index_on(1, box.high.y);
  const int first_k = index_on(2, box.low.z);
  const int last_k = index_on(2, box.high.z);
  for (int j = first_j; j <= last_j; ++j) {
    for (int k = first_k; k <= last_k; ++k) {
      const std::size_t c = cell(j, k);
      for (std::int32_t at = first_[c]; at < first_[c + 1]; ++at) {
        const std::int32_t i = items_[static_cast<std::size_t>(at)];
        const Box3& other = boxes_[static_cast<std::size_t>(i)];
        if (other.low.y > box.high.y || box.low.y > other.high.y || other.low.z > box.high.z ||
            box.low.z > other.high.z) {
          continue;
        }
        // Both may share several cells: the first of them counts.
        const bool is_first = (j == first_j || index_on(1, other.low.y) == j) &&
                              (k == first_k || index_on(2, other.low.z) == k);
        if (is_first) visit(i);
      }
    }
  }
}

}  // namespace tetfarm
