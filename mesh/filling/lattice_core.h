/// The core of the lattice: nodes so far from the boundary and from cells of another size that all
/// tets round them are the lattice's own, known without any Delaunay work.
///
/// Source: docs/kernel.md, "The lattice's own tetrahedra". A body-centred cubic lattice has one
/// Delaunay tetrahedrization (its Voronoi cells are truncated octahedra, with four cells at every
/// corner): each tet holds an edge of a cell and the two centres of the cells on a face at that
/// edge. A tet's sphere has the radius 0.56 of a cell edge; where the spheres round a node hold no
/// other point, its tets are those of the Delaunay tetrahedrization of all points.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/core/tet_complex.h"
#include "mesh/filling/lattice_grid.h"

namespace tetfarm {

/// A face of the core's hull: the number of its tet << 2 | face, and that tet's nodes. No node of
/// the face is a core node.
struct CoreHullFace {
  FaceHandle face;
  Tet tet;
};

/// The tets with at least one core node, numbered from 0. They are not kept: a bit tells which of a
/// cell's tets there are, and all else follows from the cell's place. Nodes are numbers of lattice
/// nodes. Cost: 8 bytes a cell; O(cells) to make, O(tets) to write.
class LatticeCore {
 public:
  /// No tets.
  LatticeCore() = default;
  /// @pre is_core is what find_core_nodes found, or less.
  LatticeCore(LatticeGrid grid, std::vector<std::uint8_t> is_core);

  std::int32_t tet_count() const { return tet_count_; }
  bool is_core(std::int32_t node) const { return is_core_[static_cast<std::size_t>(node)] != 0; }
  /// In their order.
  std::vector<std::int32_t> core_nodes() const;
  const std::vector<CoreHullFace>& hull() const { return hull_; }

  /// These are core nodes no more.
  void leave_out(std::span<const std::int32_t> nodes);

  /// Writes the tets into the complex, number t to first + t. Hull faces get no neighbour.
  /// @pre the complex has room for them.
  void write(TetComplex& complex, std::int32_t first,
             std::span<const std::int32_t> node_numbers) const;

 private:
  struct CellTets {
    std::int32_t first = 0;
    std::uint16_t present = 0;  // a bit for each type of tet
  };
  /// One side of two tets that touch: the cell and type of the tet, and its face there.
  struct Side {
    std::int32_t slot;
    int type;
    int face;
  };

  void find_tets();
  std::uint16_t find_tets_of(std::int32_t slot) const;
  unsigned present_at(std::int32_t slot) const;
  /// Of the cell and its three lower neighbours: has one of them tets, have all of them all?
  bool has_tets_near(std::int32_t slot) const;
  bool has_all_tets_near(std::int32_t slot) const;
  std::int32_t number_of(const Side& side) const;
  Tet nodes_of(std::int32_t slot, int type) const;
  /// Calls visit(a, b) for the pairs of tets that touch on the cell's high faces or at its edges.
  template <class Visitor>
  void visit_touching(std::int32_t slot, Visitor&& visit) const;
  void add_to_hull(const Side& side);

  LatticeGrid grid_;
  std::vector<std::uint8_t> is_core_;
  std::vector<CellTets> cells_;
  std::vector<CoreHullFace> hull_;
  std::int32_t tet_count_ = 0;
};

}  // namespace tetfarm
