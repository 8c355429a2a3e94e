/// Which triangles of a surface lie near a box, while triangles come and go.
///
/// Source: T. Ulrich, "Loose octrees", Game Programming Gems (2000): a box lies in the cell that
/// holds its middle, at the level whose cells are no smaller than it; cells count as half an edge
/// larger all round, so each box lies in one of them, wholly. Boxes that only touch count as near.
/// Boxes are kept in single precision, rounded outwards; each cell knows a hull of what is in it. A
/// triangle that is moved stays in its cell while that holds its box. Cost: O(depth) to add and
/// remove, a microsecond at most; a query O(depth + cells that meet it). 104 bytes a cell that has
/// ever been used, 36 a triangle.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "mesh/core/vec3.h"

namespace tetfarm {

class TriangleOctree {
 public:
  /// @param whole where all middles of boxes will lie; one outside is found all the same, slowly.
  explicit TriangleOctree(const Box3& whole);

  /// @pre `id` >= 0 is not in the tree.
  void add(std::int32_t id, const Box3& box);
  /// @pre `id` is in the tree.
  void remove(std::int32_t id);
  /// As removed and added again. @pre `id` is in the tree.
  void move(std::int32_t id, const Box3& box);

  /// Calls visit(id) for each triangle whose box overlaps `box`, once, in an order that depends on
  /// what has been added, moved and removed alone. One may be visited whose box is away by less
  /// than a millionth of the whole.
  template <typename Visitor>
  void query(const Box3& box, Visitor&& visit) const;

 private:
  static constexpr int most_levels = 40;

  struct Place {
    Vec3 centre;
    double half = 0;
  };
  /// As seen from the middle of the whole, and no smaller than the box that it stands for.
  struct RoughBox {
    std::array<float, 3> low{};
    std::array<float, 3> high{};
    bool overlaps(const RoughBox& b) const {
      return low[0] <= b.high[0] && b.low[0] <= high[0] && low[1] <= b.high[1] &&
             b.low[1] <= high[1] && low[2] <= b.high[2] && b.low[2] <= high[2];
    }
    bool holds(const RoughBox& b) const {
      return low[0] <= b.low[0] && b.high[0] <= high[0] && low[1] <= b.low[1] &&
             b.high[1] <= high[1] && low[2] <= b.low[2] && b.high[2] <= high[2];
    }
  };
  struct Cell {
    Place place;
    RoughBox hull;  ///< holds all that is in it or below, if anything is
    std::array<std::int32_t, 8> children{-1, -1, -1, -1, -1, -1, -1, -1};
    std::int32_t parent = -1;
    std::int32_t first = -1;  ///< of its triangles
    std::int32_t count = 0;   ///< of triangles in it, and of children that are not empty
  };
  struct Entry {
    RoughBox box;
    std::int32_t next = -1;
    std::int32_t previous = -1;  ///< -1: the first of its cell
    std::int32_t cell = -1;      ///< -1: not in the tree
  };

  static Place child_place(const Place& place, std::size_t child) {
    const double h = 0.5 * place.half;
    return {{place.centre.x + ((child & 1U) != 0 ? h : -h),
             place.centre.y + ((child & 2U) != 0 ? h : -h),
             place.centre.z + ((child & 4U) != 0 ? h : -h)},
            h};
  }
  /// Whether the cell, half an edge larger all round, holds the box.
  static bool holds(const Place& place, const Box3& box) {
    const double reach = 2 * place.half;
    const Vec3& c = place.centre;
    return c.x - reach <= box.low.x && box.high.x <= c.x + reach && c.y - reach <= box.low.y &&
           box.high.y <= c.y + reach && c.z - reach <= box.low.z && box.high.z <= c.z + reach;
  }
  RoughBox rough(const Box3& box) const;
  std::int32_t cell_for(const Box3& box);
  void put(std::int32_t id, const Box3& box, std::int32_t cell);
  void widen(std::int32_t cell, const RoughBox& box);
  template <typename Visitor>
  void query_below(std::int32_t cell, const RoughBox& box, Visitor& visit) const;

  std::vector<Cell> cells_ = std::vector<Cell>(1);
  std::vector<Entry> entries_;
};

template <typename Visitor>
void TriangleOctree::query(const Box3& box, Visitor&& visit) const {
  query_below(0, rough(box), visit);
}

template <typename Visitor>
void TriangleOctree::query_below(std::int32_t cell, const RoughBox& box, Visitor& visit) const {
  const Cell& here = cells_[static_cast<std::size_t>(cell)];
  for (std::int32_t id = here.first; id >= 0;) {
    const Entry& entry = entries_[static_cast<std::size_t>(id)];
    if (entry.box.overlaps(box)) visit(id);
    id = entry.next;
  }
  for (std::size_t child = 0; child < 8; ++child) {
    const std::int32_t below = here.children[child];
    if (below < 0) continue;
    const Cell& next = cells_[static_cast<std::size_t>(below)];
    if (next.count > 0 && next.hull.overlaps(box)) query_below(below, box, visit);
  }
}

}  // namespace tetfarm
