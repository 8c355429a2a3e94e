/// The cavity of a new point: the triangles whose circumcircle holds it, as far as they can be
/// reached without crossing a constrained edge; and its filling by triangles round the point
/// (Bowyer-Watson).
///
/// Source: thesis 3.1 (fig. 16) and 3.3.4 (restricted cavity).
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "mesh/planar/triangle_complex.h"

namespace tetfarm {

/// Work space too: keep one for many points, so that no point allocates.
struct Cavity {
  struct RimEdge {
    std::int32_t from;
    std::int32_t to;
    EdgeHandle outside;
    bool is_constrained;
  };
  std::vector<std::int32_t> triangles;
  /// Anticlockwise, each edge seen from inside.
  std::vector<RimEdge> rim;

  std::vector<EdgeHandle> stack;
  std::vector<std::uint32_t> seen;
  std::uint32_t round = 0;
};

/// The triangle that holds p (on its edge or at its corner counts), by a walk from `start`; nothing
/// when the walk is stopped by a constrained edge.
/// Cost: the triangles on the way.
std::optional<std::int32_t> locate(const TriangleComplex& complex, std::int32_t start,
                                   const Vec2& p);

/// Finds the cavity of p from the triangle that holds it; false when p does not see the whole rim
/// strictly (never so in a Delaunay triangulation, unless p is a node of it).
/// Cost: the triangles of the cavity.
bool find_cavity(const TriangleComplex& complex, std::int32_t holder, const Vec2& p,
                 Cavity& cavity);

/// Replaces the cavity's triangles by those between p and the rim; cavity.triangles becomes the
/// list of the new ones, triangle k on rim edge k with p as its node 0. Returns the node of p.
/// @pre `cavity` is as find_cavity left it for this p.
std::int32_t fill_cavity(TriangleComplex& complex, const Vec2& p, Cavity& cavity);

}  // namespace tetfarm
