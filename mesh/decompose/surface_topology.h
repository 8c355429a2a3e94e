/// What the steps of a cut ask again and again of a sub-domain's surface: neighbours, centroids,
/// sizes.
///
/// Source: thesis 4.3.1.5 ("the edge data structure is extracted from the surface triangulation").
/// Units: lengths in the unit of the input. Edge i of a triangle goes from its node i to node i
/// + 1.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/array_index.h"
#include "mesh/core/subdomain.h"

namespace tetfarm {

/// Edge e of triangle t, as 3 t + e.
using HalfEdge = std::int32_t;
constexpr HalfEdge half_edge(std::int32_t triangle, int edge) { return 3 * triangle + edge; }
constexpr std::int32_t triangle_of(HalfEdge h) { return h / 3; }
constexpr int edge_of(HalfEdge h) { return h % 3; }
constexpr HalfEdge next_in_triangle(HalfEdge h) { return h % 3 == 2 ? h - 2 : h + 1; }

struct SurfaceTopology {
  std::vector<HalfEdge> twin;                // the same edge, the other way, in the neighbour
  std::vector<Vec3> centroid;                // of each triangle
  std::vector<Vec3> normal;                  // of each triangle, outward, of length twice its area
  std::vector<double> size;                  // mean edge length of each triangle
  std::vector<HalfEdge> vertex2half_edge;    // one that starts at the vertex
  std::vector<std::int32_t> triangle2shell;  // shells are numbered by their first triangle
};

/// Where more than two triangles share an edge, they are paired in the order of their numbers.
/// @pre the surface is closed and every vertex is used. Cost: O(n).
SurfaceTopology make_surface_topology(const Subdomain& subdomain);

inline std::int32_t start_of(const std::vector<Triangle>& triangles, HalfEdge h) {
  return triangles[at(triangle_of(h))][at(edge_of(h))];
}
inline std::int32_t end_of(const std::vector<Triangle>& triangles, HalfEdge h) {
  return start_of(triangles, next_in_triangle(h));
}

/// The half-edges that start at the vertex of `h`, once round, beginning with `h` (one umbrella of
/// triangles when several meet in the vertex).
std::vector<HalfEdge> half_edges_round_start(const SurfaceTopology& topology, HalfEdge h);

}  // namespace tetfarm
