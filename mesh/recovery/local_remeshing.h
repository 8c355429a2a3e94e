/// Small changes of a TetComplex that can be taken back: a set of tets is replaced by another set
/// that fills the same space, and a journal restores the complex exactly as it was.
///
/// Boundary recovery tries many changes and keeps few. Constrained faces (a bit for each face of a
/// tet, set on both sides) go over to the new tets.
/// Cost: O(k log k) for k tets replaced; O(changes) to take back.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "mesh/core/tet_complex.h"
#include "mesh/core/tet_marks.h"
#include "mesh/geometry/fine_point.h"
#include "mesh/geometry/predicates.h"
#include "mesh/recovery/surface_flats.h"

namespace tetfarm {

/// The tets round an edge (a, b): tets[i] has the nodes a, b, apexes[i], apexes[i + 1] (cyclic) and
/// is positive in that order.
struct EdgeRing {
  std::vector<std::int32_t> tets;
  std::vector<std::int32_t> apexes;
};

class LocalRemeshing {
 public:
  /// Keeps references; `constrained` has a byte for each tet.
  LocalRemeshing(TetComplex& complex, std::vector<std::uint8_t>& constrained);

  const TetComplex& complex() const { return complex_; }
  const Vec3& point(std::int32_t v) const { return complex_.points[static_cast<std::size_t>(v)]; }
  /// The point to its last bit: those that add_point brought may have more than a double holds.
  FinePoint fine_point(std::int32_t v) const { return {point(v), low_of(v)}; }
  /// orient3d of the points to their last bit, but 0 where they are flat by construction.
  double orient(std::int32_t a, std::int32_t b, std::int32_t c, std::int32_t d) const {
    if (std::max(std::max(a, b), std::max(c, d)) < first_fine_) {
      return orient3d(point(a), point(b), point(c), point(d));
    }
    if (flats_.are_flat({a, b, c, d})) return 0;
    return orient3d(fine_point(a), fine_point(b), fine_point(c), fine_point(d));
  }

  /// Replaces `old_tets` by `new_tets` (mesh/core/tet_replacement.h). @pre both fill the same
  /// space, the new ones are positive, and no constrained face lies between two old ones.
  /// Returns the numbers of the new tets.
  std::vector<std::int32_t> replace(std::span<const std::int32_t> old_tets,
                                    std::span<const Tet> new_tets);

  bool are_in_line(std::int32_t a, std::int32_t b, std::int32_t c) const {
    return flats_.are_in_line({a, b, c});
  }

  /// Adds a point; it belongs to no tet yet. The complex holds it rounded; what is lost by that
  /// lives as long as this.
  std::int32_t add_point(const FinePoint& point);
  /// The same for a point on the edge (two corners) or in the triangle (three) of the surface.
  std::int32_t add_point_on(std::span<const std::int32_t> corners, const FinePoint& point);
  /// Before the first point on it: what of the surface is flat.
  void know_surface(const std::vector<Triangle>& triangles) {
    flats_ = SurfaceFlats(complex_.points, triangles);
  }
  /// The point is on no edge or face any more. Not in the journal. @pre the point came by
  /// add_point.
  void move_point(std::int32_t v, const FinePoint& to);

  std::size_t mark() const { return journal_.size(); }
  /// Takes back every change since the mark.
  void roll_back(std::size_t mark);
  /// What was done stays done.
  void forget_journal() { journal_.clear(); }

  /// All tets that hold the node, from a walk over its star.
  std::vector<std::int32_t> star(std::int32_t node) const;
  /// A tet with both nodes, or -1.
  std::int32_t find_edge(std::int32_t a, std::int32_t b) const;
  /// The face with these three nodes, or no_face.
  FaceHandle find_face(std::int32_t a, std::int32_t b, std::int32_t c) const;
  /// Nothing when there is no such edge, or the edge is on the outside of the complex.
  std::optional<EdgeRing> ring(std::int32_t a, std::int32_t b) const;
  /// The same from a tet that holds the edge. Cost: O(ring).
  std::optional<EdgeRing> ring_from(std::int32_t tet, std::int32_t a, std::int32_t b) const;

  bool is_constrained(FaceHandle face) const {
    return (constrained_[static_cast<std::size_t>(tet_of(face))] >> face_of(face) & 1) != 0;
  }
  /// Whether a face between the edge and an apex is constrained.
  bool has_constraint(const EdgeRing& ring) const;
  /// Sets or clears both sides. Not in the journal: called between searches only.
  void constrain(FaceHandle face, bool on);

 private:
  struct Entry {
    enum class Kind : std::uint8_t { contents, reused, appended, killed, point } kind;
    std::uint8_t constrained;
    std::int32_t tet;
    Tet nodes;
    std::array<FaceHandle, 4> neighbours;
  };

  Vec3 low_of(std::int32_t v) const {
    return v < first_fine_ ? Vec3{} : low_[static_cast<std::size_t>(v - first_fine_)];
  }
  void save(std::int32_t tet);
  void save_old(std::int32_t tet);

  TetComplex& complex_;
  std::vector<std::uint8_t>& constrained_;
  std::int32_t first_fine_;  // points from here on came by add_point
  std::vector<Vec3> low_;    // of them: what rounding has taken off
  SurfaceFlats flats_;
  std::vector<Entry> journal_;
  mutable TetMarks marks_;
};

}  // namespace tetfarm
