/// A static tree over boxes: finds all boxes that overlap a given one, or each other.
///
/// Source: thesis 4.3.1.7 needs the surface triangles near each triangle of a cut; the tree is the
/// usual bounding volume hierarchy, split at the median of the box centres along the longest axis.
/// Boxes that only touch overlap. Visits come in an order that depends on the boxes alone.
/// Cost: build O(n log n), about 80 bytes a box, with those of boxes that are moved in; a query
/// O(log n + hits) for boxes that overlap little.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/core/surface_mesh.h"
#include "mesh/core/vec3.h"

namespace tetfarm {

class BoxTree {
 public:
  BoxTree() = default;
  /// @pre no box is empty or holds a NaN.
  explicit BoxTree(std::vector<Box3> boxes);

  std::size_t size() const { return items_.size(); }

  /// Calls visit(i) for every box i that overlaps `box`.
  template <typename Visitor>
  void query(const Box3& box, Visitor&& visit) const {
    any(box, [&visit](std::int32_t i) {
      visit(i);
      return false;
    });
  }

  /// As query, but stops at the first i for which holds(i); true when there was one.
  template <typename Predicate>
  bool any(const Box3& box, Predicate&& holds) const;

  /// Calls visit(i, j), i < j, once for every two boxes that overlap.
  template <typename Visitor>
  void self_pairs(Visitor&& visit) const;

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

  void build(std::int32_t first, std::int32_t last);
  void put_boxes_in_order();
  const Node& node(std::int32_t i) const { return nodes_[static_cast<std::size_t>(i)]; }

  template <typename Visitor>
  void pairs_between(std::int32_t a, std::int32_t b, Visitor& visit) const;
  template <typename Visitor>
  void pairs_of_leaves(const Node& a, const Node& b, Visitor& visit) const;

  std::vector<Node> nodes_;
  std::vector<std::int32_t> items_;
  std::vector<Box3> item_boxes_;  // in the order of items_, once the tree is built
};

/// The box of each triangle.
std::vector<Box3> triangle_boxes(std::span<const Vec3> vertices,
                                 std::span<const Triangle> triangles);

template <typename Predicate>
bool BoxTree::any(const Box3& box, Predicate&& holds) const {
  if (nodes_.empty()) return false;
  std::array<std::int32_t, most_depth> stack{};
  std::size_t top = 0;
  stack[top++] = 0;
  while (top > 0) {
    const std::int32_t i = stack[--top];
    const Node& n = node(i);
    if (!n.box.overlaps(box)) continue;
    if (n.count == 0) {
      stack[top++] = n.right;
      stack[top++] = i + 1;
      continue;
    }
    for (std::int32_t k = n.first; k < n.first + n.count; ++k) {
      const auto item = static_cast<std::size_t>(k);
      if (item_boxes_[item].overlaps(box) && holds(items_[item])) return true;
    }
  }
  return false;
}

template <typename Visitor>
void BoxTree::self_pairs(Visitor&& visit) const {
  if (!nodes_.empty()) pairs_between(0, 0, visit);
}

template <typename Visitor>
void BoxTree::pairs_between(std::int32_t a, std::int32_t b, Visitor& visit) const {
  const Node& m = node(a);
  const Node& n = node(b);
  if (a == b && m.count == 0) {
    pairs_between(a + 1, a + 1, visit);
    pairs_between(m.right, m.right, visit);
    pairs_between(a + 1, m.right, visit);
    return;
  }
  if (!m.box.overlaps(n.box)) return;
  if (m.count > 0 && n.count > 0) {
    pairs_of_leaves(m, n, visit);
  } else if (n.count > 0 || (m.count == 0 && norm2(m.box.size()) > norm2(n.box.size()))) {
    pairs_between(a + 1, b, visit);
    pairs_between(m.right, b, visit);
  } else {
    pairs_between(a, b + 1, visit);
    pairs_between(a, n.right, visit);
  }
}

template <typename Visitor>
void BoxTree::pairs_of_leaves(const Node& a, const Node& b, Visitor& visit) const {
  for (std::int32_t k = a.first; k < a.first + a.count; ++k) {
    const auto i = static_cast<std::size_t>(k);
    for (std::int32_t l = &a == &b ? k + 1 : b.first; l < b.first + b.count; ++l) {
      const auto j = static_cast<std::size_t>(l);
      if (item_boxes_[i].overlaps(item_boxes_[j])) {
        visit(std::min(items_[i], items_[j]), std::max(items_[i], items_[j]));
      }
    }
  }
}

}  // namespace tetfarm
