/// Inserts points into a TetComplex by the cavity method: the tets whose spheres hold the point are
/// removed and their hull is joined to it.
///
/// Source: A. Bowyer (1981), D. F. Watson (1981); thesis 3.2 and 4.3.3. With constrained faces the
/// cavity stops at them and shrinks until the point sees all of its hull (P. L. George, H.
/// Borouchaki, "Delaunay Triangulation and Meshing", 1998). Cost: O(1) a point in practice; no
/// allocation per point.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/core/tet_complex.h"

namespace tetfarm {

class CavityInsertion {
 public:
  /// Keeps a reference. `constrained` has a byte for each tet whose bit i says that face i may not
  /// be crossed (set on both sides); it may be empty: plain Delaunay. It grows with the complex.
  /// `ids` are the numbers by which cospherical points are perturbed; empty: those of the nodes.
  explicit CavityInsertion(TetComplex& complex, std::vector<std::uint8_t>* constrained = nullptr,
                           std::span<const std::int32_t> ids = {});

  /// Gathers the cavity of complex.points[node], which lies in the closure of `tet`. False when no
  /// cavity is left from which the node sees the whole hull; then nothing has changed.
  bool find_cavity(std::int32_t node, std::int32_t tet);

  /// The cavity's tets and the faces of its hull, as seen from inside, after find_cavity.
  const std::vector<std::int32_t>& cavity() const { return cavity_; }
  const std::vector<FaceHandle>& hull() const { return hull_; }

  /// Replaces the cavity by the star of the node of find_cavity; returns a tet of the star.
  std::int32_t fill();

 private:
  /// A hull face as it was: its nodes, the face beyond it, and whether it is constrained.
  struct Base {
    std::array<std::int32_t, 3> nodes;
    std::array<std::int32_t, 3> local;  // numbers of the nodes on this hull
    std::int32_t tet;                   // of the star, on this face
    FaceHandle outside;
    bool constrained;
  };

  void grow(std::int32_t tet);
  bool is_constrained(FaceHandle face) const;
  bool drop_enclosed_constraints();
  bool shrink_to_visible();
  void rebuild_hull();
  bool in_cavity(std::int32_t tet) const { return mark_[static_cast<std::size_t>(tet)] == round_; }
  bool sphere_holds(std::int32_t tet) const;
  void gather_bases();
  void take_tets();
  void glue_star();
  void glue_large_star();
  template <class FaceOfEdge>
  void link_star(const FaceOfEdge& face_of_edge);

  TetComplex& complex_;
  std::vector<std::uint8_t>* constrained_;
  std::span<const std::int32_t> ids_;
  std::vector<std::int32_t> mark_;   // of a tet: the round in which it was in the cavity
  std::vector<std::int32_t> local_;  // of a node: its number on the hull, or -1
  std::int32_t round_ = 0;
  std::int32_t node_ = -1;
  Vec3 point_;  // of node_
  std::int32_t seed_ = -1;
  std::vector<std::int32_t> cavity_;
  std::vector<FaceHandle> hull_;
  std::vector<Base> bases_;
  std::vector<std::int32_t> hull_nodes_;  // by their numbers on the hull
  std::vector<std::int32_t> hull_tets_;   // a tet of the star at each of them
  std::vector<FaceHandle> edge_table_;
};

}  // namespace tetfarm
