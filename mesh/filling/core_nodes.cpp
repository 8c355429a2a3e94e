#include "mesh/filling/core_nodes.h"

#include <array>
#include <optional>

#include "base/array_index.h"
#include "base/check.h"
#include "mesh/geometry/box_tree.h"
#include "mesh/geometry/triangle_distance.h"

namespace tetfarm {
namespace {

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

Box3 box_round(const Vec3& p, double reach) {
  const Vec3 d{reach, reach, reach};
  return {p - d, p + d};
}

/// The boundary's triangles without the faces of the lattice, by their boxes.
class OtherFaces {
 public:
  /// Keeps references; `tree` is of all triangles.
  OtherFaces(const Subdomain& subdomain, const BoxTree& tree, const LatticeBoundary& boundary)
      : tree_(tree) {
    if (boundary.node2vertex.empty()) return;
    std::vector<Triangle> others;
    for (std::size_t t = 0; t < subdomain.triangles.size(); ++t) {
      if (boundary.is_lattice_face[t] != 0) continue;
      others.push_back(subdomain.triangles[t]);
      numbers_.push_back(static_cast<std::int32_t>(t));
    }
    tree_of_others_ = BoxTree(triangle_boxes(subdomain.vertices, others));
  }

  /// Whether one with a box that overlaps this one satisfies holds(triangle).
  template <typename Predicate>
  bool any(const Box3& box, Predicate&& holds) const {
    if (!tree_of_others_) return tree_.any(box, holds);
    return tree_of_others_->any(box, [&](std::int32_t i) { return holds(numbers_[at(i)]); });
  }

 private:
  const BoxTree& tree_;
  std::optional<BoxTree> tree_of_others_;  // where there are cuts
  std::vector<std::int32_t> numbers_;
};

/// Which nodes keep clear of all faces but the lattice's. Asks for whole blocks first: most are far
/// from everything.
class Clearance {
 public:
  Clearance(std::span<const LatticeNode> nodes, const LatticeGrid& grid, const Subdomain& subdomain,
            const BoxTree& tree, const LatticeBoundary& boundary)
      : nodes_(nodes), grid_(grid), subdomain_(subdomain), faces_(subdomain, tree, boundary) {}

  void enter_block(std::int32_t first_slot) {
    Box3 box;
    for (std::int32_t slot = first_slot; slot < first_slot + LatticeGrid::slots_in_block; ++slot) {
      for (const std::int32_t node : {grid_.centre(slot), grid_.low_corner(slot)}) {
        if (node == LatticeGrid::none) continue;
        const LatticeNode& n = nodes_[at(node)];
        box.add(box_round(n.at, core_reach * n.cell_edge));
      }
    }
    block_is_clear_ = !faces_.any(box, [](std::int32_t) { return true; });
  }
  bool is_clear(std::int32_t node) {
    if (block_is_clear_) return true;
    const Vec3& p = nodes_[at(node)].at;
    const double reach = core_reach * nodes_[at(node)].cell_edge;
    const auto is_near = [&](std::int32_t i) {
      const auto& [a, b, c] = subdomain_.triangles[at(i)];
      return is_nearer_to_triangle(p, subdomain_.vertices[at(a)], subdomain_.vertices[at(b)],
                                   subdomain_.vertices[at(c)], reach);
    };
    // What was too near to the nodes before is too near to many of their neighbours.
    for (const std::int32_t i : too_near_) {
      if (i >= 0 && is_near(i)) return false;
    }
    return !faces_.any(box_round(p, reach), [&](std::int32_t i) {
      if (!is_near(i)) return false;
      too_near_[next_++ % too_near_.size()] = i;
      return true;
    });
  }

 private:
  std::span<const LatticeNode> nodes_;
  const LatticeGrid& grid_;
  const Subdomain& subdomain_;
  OtherFaces faces_;
  bool block_is_clear_ = false;
  std::array<std::int32_t, 4> too_near_ = {-1, -1, -1, -1};
  std::size_t next_ = 0;
};

/// The slots within three steps on each axis of one with a vertex of the boundary: a face within
/// reach of a node has a vertex within 2.1 cell edges of it.
std::vector<std::uint8_t> slots_near_vertices(const LatticeGrid& grid,
                                              const LatticeBoundary& boundary) {
  constexpr int steps = 3;
  std::vector<std::uint8_t> is_near(at(grid.slot_count()), 0);
  std::vector<std::int32_t> reached;
  const auto reach = [&](std::int32_t slot) {
    if (slot == LatticeGrid::none || is_near[at(slot)] != 0) return;
    is_near[at(slot)] = 1;
    reached.push_back(slot);
  };
  const auto has_vertex = [&](std::int32_t node) {
    return node != LatticeGrid::none && boundary.has_vertex_at(at(node));
  };
  for (std::int32_t slot = 0; slot < grid.slot_count() && !boundary.node2vertex.empty(); ++slot) {
    if (has_vertex(grid.centre(slot)) || has_vertex(grid.low_corner(slot))) reach(slot);
  }
  for (int axis = 0; axis < 3; ++axis) {
    const std::size_t count = reached.size();
    for (std::size_t i = 0; i < count; ++i) {
      for (const int side : {-1, 1}) {
        std::int32_t slot = reached[i];
        for (int step = 0; step < steps && slot != LatticeGrid::none; ++step) {
          slot = grid.neighbour(slot, axis == 0 ? side : 0, axis == 1 ? side : 0,
                                axis == 2 ? side : 0);
          reach(slot);
        }
      }
    }
  }
  return is_near;
}

}  // namespace

std::vector<std::uint8_t> find_core_nodes(std::span<const LatticeNode> nodes,
                                          const LatticeGrid& grid, const Subdomain& subdomain,
                                          const BoxTree& tree, const LatticeBoundary& boundary) {
  std::vector<std::uint8_t> across_faces(at(grid.slot_count()), 0);
  for (std::int32_t slot = 0; slot < grid.slot_count(); ++slot) {
    across_faces[at(slot)] =
        is_in_deep_block(grid, slot) ||
                (is_cell(grid, slot) && has_equal_cells_across_faces(grid, slot))
            ? 1
            : 0;
  }
  std::vector<std::uint8_t> kinds(nodes.size(), not_core);
  Clearance clearance(nodes, grid, subdomain, tree, boundary);
  TF_CHECK(boundary.is_lattice_face.size() == subdomain.triangles.size());
  const std::vector<std::uint8_t> is_near_vertex = slots_near_vertices(grid, boundary);
  const auto kind_of = [&](std::int32_t node, std::int32_t slot) {
    if (boundary.has_vertex_at(at(node)) || !clearance.is_clear(node)) return not_core;
    return is_near_vertex[at(slot)] != 0 ? core_at_cut : core_away;
  };
  for (std::int32_t slot = 0; slot < grid.slot_count(); ++slot) {
    if (slot % LatticeGrid::slots_in_block == 0) clearance.enter_block(slot);
    const bool is_deep = is_in_deep_block(grid, slot);
    const std::int32_t centre = grid.centre(slot);
    if (centre != LatticeGrid::none && across_faces[at(slot)] != 0 &&
        (is_deep || has_equal_cells_around(grid, slot))) {
      kinds[at(centre)] = kind_of(centre, slot);
    }
    const std::int32_t corner = grid.low_corner(slot);
    if (corner != LatticeGrid::none &&
        (is_deep || has_equal_cells_at_corner(grid, slot, across_faces))) {
      kinds[at(corner)] = kind_of(corner, slot);
    }
  }
  return kinds;
}

}  // namespace tetfarm
