#include "mesh/volume/core_nodes.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "mesh/geometry/box_tree.h"
#include "mesh/geometry/triangle_distance.h"

namespace tetfarm {
namespace {

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

bool is_cell(const LatticeGrid& grid, std::int32_t slot) {
  return slot != LatticeGrid::none && grid.centre(slot) != LatticeGrid::none;
}

bool is_in_deep_block(const LatticeGrid& grid, std::int32_t slot) {
  return grid.is_deep(slot / LatticeGrid::slots_in_block);
}

bool has_equal_cells_across_faces(const LatticeGrid& grid, std::int32_t slot) {
  return is_cell(grid, grid.neighbour(slot, -1, 0, 0)) &&
         is_cell(grid, grid.neighbour(slot, 1, 0, 0)) &&
         is_cell(grid, grid.neighbour(slot, 0, -1, 0)) &&
         is_cell(grid, grid.neighbour(slot, 0, 1, 0)) &&
         is_cell(grid, grid.neighbour(slot, 0, 0, -1)) &&
         is_cell(grid, grid.neighbour(slot, 0, 0, 1));
}

/// The 26 cells round it are as large. Then the spheres at its centre, which reach 1.12 edges far,
/// hold no node of a smaller cell.
bool has_equal_cells_around(const LatticeGrid& grid, std::int32_t slot) {
  for (int z = -1; z <= 1; ++z) {
    for (int y = -1; y <= 1; ++y) {
      for (int x = -1; x <= 1; ++x) {
        if (!is_cell(grid, grid.neighbour(slot, x, y, z))) return false;
      }
    }
  }
  for (std::size_t k = 0; k < 8; ++k) {
    if (grid.corner(slot, k) == LatticeGrid::none) return false;
  }
  return true;
}

/// The same for the low corner of the cell: the eight cells at it, and those across their faces.
bool has_equal_cells_at_corner(const LatticeGrid& grid, std::int32_t slot,
                               const std::vector<std::uint8_t>& across_faces) {
  for (int k = 0; k < 8; ++k) {
    const std::int32_t cell = grid.neighbour(slot, -(k & 1), -(k >> 1 & 1), -(k >> 2 & 1));
    if (cell == LatticeGrid::none || across_faces[at(cell)] == 0) return false;
  }
  return true;
}

/// The nodes of a block that would be core nodes, were they far from the boundary; all of them in
/// cells of one size.
struct Candidates {
  std::vector<std::int32_t> nodes;
  std::vector<Vec3> at;
  double cell_edge = 0;

  void clear() {
    nodes.clear();
    at.clear();
  }
  void add(std::int32_t number, const LatticeNode& node) {
    nodes.push_back(number);
    at.push_back(node.at);
    cell_edge = node.cell_edge;
  }
  std::size_t size() const { return nodes.size(); }
  void drop(std::size_t i) {
    nodes[i] = nodes.back();
    at[i] = at.back();
    nodes.pop_back();
    at.pop_back();
  }
};

/// A triangle, with what tells most nodes that they are far from it.
struct NearTriangle {
  Vec3 a, b, c;
  Vec3 normal;
  double largest_height = 0;  ///< over the plane, times the normal's length
  Vec3 centre;
  double farthest2 = 0;  ///< from the centre, squared

  NearTriangle(const Vec3& a_, const Vec3& b_, const Vec3& c_, double reach)
      : a(a_), b(b_), c(c_), normal(cross(b - a, c - a)), centre((a + b + c) / 3) {
    // A little more than what is exactly meant: is_nearer_to_triangle has the last word.
    constexpr double margin = 1 + 1e-9;
    const double radius =
        std::sqrt(std::max({norm2(a - centre), norm2(b - centre), norm2(c - centre)}));
    largest_height = margin * reach * norm(normal);
    farthest2 = margin * (reach + radius) * (reach + radius);
  }
  bool may_be_near(const Vec3& p) const {
    return std::abs(dot(normal, p - a)) <= largest_height && norm2(p - centre) <= farthest2;
  }
};

/// Drops the candidates with a boundary triangle nearer than core_reach. The triangles near a block
/// are found once for all its nodes.
class Clearance {
 public:
  explicit Clearance(const Subdomain& subdomain)
      : subdomain_(subdomain), boundary_(triangle_boxes(subdomain.vertices, subdomain.triangles)) {}

  void keep_clear(Candidates& candidates) {
    if (candidates.size() == 0) return;
    const double reach = core_reach * candidates.cell_edge;
    Box3 box;
    for (const Vec3& p : candidates.at) box.add(p);
    box.low -= Vec3{reach, reach, reach};
    box.high += Vec3{reach, reach, reach};
    triangles_.clear();
    boundary_.query(box, [&](std::int32_t i) {
      const auto& [a, b, c] = subdomain_.triangles[at(i)];
      triangles_.emplace_back(subdomain_.vertices[at(a)], subdomain_.vertices[at(b)],
                              subdomain_.vertices[at(c)], reach);
    });
    for (std::size_t i = candidates.size(); i-- > 0;) {
      if (is_near_any(candidates.at[i], reach)) candidates.drop(i);
    }
  }

 private:
  /// What is near comes first for the next node, which is a neighbour.
  bool is_near_any(const Vec3& p, double reach) {
    for (NearTriangle& triangle : triangles_) {
      if (!triangle.may_be_near(p) ||
          !is_nearer_to_triangle(p, triangle.a, triangle.b, triangle.c, reach)) {
        continue;
      }
      std::swap(triangle, triangles_.front());
      return true;
    }
    return false;
  }

  const Subdomain& subdomain_;
  BoxTree boundary_;
  std::vector<NearTriangle> triangles_;
};

}  // namespace

std::vector<std::uint8_t> find_core_nodes(std::span<const LatticeNode> nodes,
                                          const LatticeGrid& grid, const Subdomain& subdomain) {
  std::vector<std::uint8_t> across_faces(at(grid.slot_count()), 0);
  for (std::int32_t slot = 0; slot < grid.slot_count(); ++slot) {
    across_faces[at(slot)] =
        is_in_deep_block(grid, slot) ||
                (is_cell(grid, slot) && has_equal_cells_across_faces(grid, slot))
            ? 1
            : 0;
  }
  std::vector<std::uint8_t> is_core(nodes.size(), 0);
  Clearance clearance(subdomain);
  Candidates candidates;
  for (std::int32_t first = 0; first < grid.slot_count(); first += LatticeGrid::slots_in_block) {
    candidates.clear();
    const bool is_deep = is_in_deep_block(grid, first);
    for (std::int32_t slot = first; slot < first + LatticeGrid::slots_in_block; ++slot) {
      const std::int32_t centre = grid.centre(slot);
      if (centre != LatticeGrid::none && across_faces[at(slot)] != 0 &&
          (is_deep || has_equal_cells_around(grid, slot))) {
        candidates.add(centre, nodes[at(centre)]);
      }
      const std::int32_t corner = grid.low_corner(slot);
      if (corner != LatticeGrid::none &&
          (is_deep || has_equal_cells_at_corner(grid, slot, across_faces))) {
        candidates.add(corner, nodes[at(corner)]);
      }
    }
    clearance.keep_clear(candidates);
    for (const std::int32_t v : candidates.nodes) is_core[at(v)] = 1;
  }
  return is_core;
}

}  // namespace tetfarm
