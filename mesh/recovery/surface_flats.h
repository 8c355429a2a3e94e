/// Which nodes lie in one plane or on one line of the surface by construction, whatever rounding
/// says.
///
/// Steiner points are put on edges and faces; four of one plane, or three of one line, make no tet,
/// however their last bits lie. Coplanar neighbours among the triangles count as one plane. Cost:
/// the surface once; a few comparisons a question.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/core/surface_mesh.h"

namespace tetfarm {

class SurfaceFlats {
 public:
  SurfaceFlats() = default;
  /// The triangles' corners are points.
  SurfaceFlats(std::span<const Vec3> points, const std::vector<Triangle>& triangles);

  /// The node lies inside the edge (two nodes) or the triangle (three) of these.
  void add(std::int32_t node, std::span<const std::int32_t> corners);
  /// The node lies on nothing any more.
  void remove(std::int32_t node);
  /// Whether the four lie in one plane, or three of them on one line, by construction.
  bool are_flat(const std::array<std::int32_t, 4>& nodes) const;
  /// Whether the three lie on one line by construction.
  bool are_in_line(const std::array<std::int32_t, 3>& nodes) const;

 private:
  using Ids = std::vector<std::int32_t>;  // in increasing order
  const Ids& planes(std::int32_t node) const { return of(planes_, node); }
  const Ids& lines(std::int32_t node) const { return of(lines_, node); }
  static const Ids& of(const std::vector<Ids>& all, std::int32_t node);
  void make_room(std::int32_t node);
  std::int32_t line_through(std::int32_t a, std::int32_t b);

  std::vector<Ids> planes_;  // of each node
  std::vector<Ids> lines_;
  std::int32_t count_of_lines_ = 0;
};

}  // namespace tetfarm
