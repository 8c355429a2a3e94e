/// Trees of boxes, one for each group of items, that find the item of a group nearest to a point.
///
/// Source: N. Roussopoulos, S. Kelley and F. Vincent, "Nearest neighbor queries" (1995): branch and
/// bound, the nearer child first. Split at the median of the box centres along the longest axis. Of
/// items equally near the one found first is taken, which depends on the boxes alone. Cost: build
/// O(n log n), about 70 bytes an item; a query O(log n) of a group whose items overlap little.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "mesh/core/vec3.h"
#include "mesh/geometry/box_measures.h"

namespace tetfarm {

class BoxForest {
 public:
  BoxForest() = default;
  /// @param group of each box, from 0. @pre no box is empty or holds a NaN.
  BoxForest(std::span<const Box3> boxes, std::span<const std::int32_t> group,
            std::int32_t group_count);

  std::int32_t group_count() const { return static_cast<std::int32_t>(roots_.size()); }

  struct Nearest {
    std::int32_t item = -1;  ///< -1: none is nearer than the limit
    double distance2 = 0;
  };
  /// The item of the group for which distance2(item), never less than that of its box, is least,
  /// and less than limit2. Where it is no number or too large, the item is passed over.
  template <typename Distance2>
  Nearest nearest(std::int32_t group, const Vec3& p, double limit2, Distance2&& distance2) const {
    return search<false>(group, p, limit2, distance2);
  }
  /// The same of any item that is nearer than the limit.
  template <typename Distance2>
  Nearest near(std::int32_t group, const Vec3& p, double limit2, Distance2&& distance2) const {
    return search<true>(group, p, limit2, distance2);
  }

 private:
  static constexpr std::size_t most_depth = 64;
  /// A leaf has count > 0 and items [first, first + count); otherwise the children are this + 1 and
  /// `right`.
  struct Node {
    Box3 box;
    std::int32_t first = 0;
    std::int32_t count = 0;
    std::int32_t right = 0;
  };
  template <bool is_any_enough, typename Distance2>
  Nearest search(std::int32_t group, const Vec3& p, double limit2, Distance2&& distance2) const;
  void build(std::span<const Box3> boxes, std::int32_t first, std::int32_t last);

  std::vector<Node> nodes_;
  std::vector<std::int32_t> items_;
  std::vector<std::int32_t> roots_;  ///< of each group; -1: it has no items
};

template <bool is_any_enough, typename Distance2>
BoxForest::Nearest BoxForest::search(std::int32_t group, const Vec3& p, double limit2,
                                     Distance2&& distance2) const {
  Nearest best{-1, limit2};
  const std::int32_t root = roots_[static_cast<std::size_t>(group)];
  if (root < 0) return best;
  struct Waiting {
    std::int32_t node;
    double distance2;
  };
  std::array<Waiting, most_depth> stack;
  std::size_t top = 0;
  stack[top++] = {root, distance2_to_box(nodes_[static_cast<std::size_t>(root)].box, p)};
  while (top > 0) {
    const Waiting next = stack[--top];
    if (!(next.distance2 < best.distance2)) continue;
    const Node& n = nodes_[static_cast<std::size_t>(next.node)];
    if (n.count > 0) {
      for (std::int32_t k = n.first; k < n.first + n.count; ++k) {
        const std::int32_t item = items_[static_cast<std::size_t>(k)];
        const double d2 = distance2(item);
        if (d2 < best.distance2) best = {item, d2};
        if (is_any_enough && best.item >= 0) return best;
      }
      continue;
    }
    Waiting near{next.node + 1, 0};
    Waiting far{n.right, 0};
    near.distance2 = distance2_to_box(nodes_[static_cast<std::size_t>(near.node)].box, p);
    far.distance2 = distance2_to_box(nodes_[static_cast<std::size_t>(far.node)].box, p);
    if (far.distance2 < near.distance2) std::swap(near, far);
    if (far.distance2 < best.distance2) stack[top++] = far;
    if (near.distance2 < best.distance2) stack[top++] = near;
  }
  return best;
}

}  // namespace tetfarm
