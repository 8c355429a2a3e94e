/// Triangles of the plane with their neighbours: the working form of the planar kernel. PlanarMesh
/// is the published form.
///
/// Source: thesis 3.1 (connectivity and neighbours of the Delaunay kernel).
/// Orientation: triangles are anticlockwise; edge i of a triangle is opposite its node i and runs
/// from node next(i) to node previous(i). 32-bit handles: fewer than 2^29 triangles.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "mesh/geometry/predicates.h"

namespace tetfarm {

/// An edge of a triangle: triangle << 2 | edge. `no_edge` means nothing on the other side.
using EdgeHandle = std::int32_t;
inline constexpr EdgeHandle no_edge = -1;
inline constexpr EdgeHandle edge_handle(std::int32_t triangle, int edge) {
  return triangle << 2 | edge;
}
inline constexpr std::int32_t triangle_of(EdgeHandle handle) { return handle >> 2; }
inline constexpr int edge_of(EdgeHandle handle) { return handle & 3; }
inline constexpr int next(int local) { return local == 2 ? 0 : local + 1; }
inline constexpr int previous(int local) { return local == 0 ? 2 : local - 1; }

/// Invariants (validate): 1. the nodes of a triangle turn anticlockwise, exactly; 2. the neighbour
/// of an edge is the same edge backwards and points back; 3. both sides agree whether the edge is
/// constrained, and an edge with nothing on the other side is constrained; 4. node2triangle[v] is a
/// triangle that holds v, or -1 when none does.
struct TriangleComplex {
  using Nodes = std::array<std::int32_t, 3>;

  std::vector<Vec2> points;
  std::vector<Nodes> triangles;
  std::vector<std::array<EdgeHandle, 3>> neighbours;
  /// Bit i: edge i may not be flipped, nor may a cavity grow across it.
  std::vector<std::uint8_t> constrained;
  std::vector<std::int32_t> node2triangle;

  const Vec2& point(std::int32_t v) const { return points[static_cast<std::size_t>(v)]; }
  const Nodes& nodes(std::int32_t t) const { return triangles[static_cast<std::size_t>(t)]; }
  std::int32_t node(std::int32_t t, int local) const {
    return nodes(t)[static_cast<std::size_t>(local)];
  }
  EdgeHandle neighbour(std::int32_t t, int edge) const {
    return neighbours[static_cast<std::size_t>(t)][static_cast<std::size_t>(edge)];
  }
  bool is_constrained(std::int32_t t, int edge) const {
    return (constrained[static_cast<std::size_t>(t)] >> edge & 1) != 0;
  }
  std::int32_t size() const { return static_cast<std::int32_t>(triangles.size()); }
  /// The local number of node v in the triangle; v must be there.
  int local_node(std::int32_t t, std::int32_t v) const {
    const Nodes& n = nodes(t);
    return n[0] == v ? 0 : n[1] == v ? 1 : 2;
  }

  /// A new isolated point.
  std::int32_t add_point(const Vec2& p);
  /// A new triangle without nodes or neighbours.
  std::int32_t add_triangle();
  /// Replaces the triangle: its nodes, no neighbours, nothing constrained.
  void set_triangle(std::int32_t t, const Nodes& nodes);
  /// Makes the two edges each other's neighbours; b may be no_edge.
  void glue(EdgeHandle a, EdgeHandle b);
  /// Sets or clears the constrained flag on both sides of the edge.
  void constrain(EdgeHandle edge, bool on);
  /// The edge from node a to node b, seen from the triangle on its left; no_edge when there is
  /// none. Cost: the triangles round a.
  EdgeHandle find_edge(std::int32_t a, std::int32_t b) const;
  /// Replaces the edge shared by two triangles by the other diagonal of their quadrilateral.
  /// @pre the edge has a neighbour, is not constrained, and the quadrilateral is strictly convex.
  void flip(EdgeHandle edge);
};

/// The triangles with neighbours; every edge without a partner becomes constrained.
/// Cost: O(n log n).
TriangleComplex make_triangle_complex(std::vector<Vec2> points,
                                      std::vector<TriangleComplex::Nodes> triangles);

/// The two nodes of each edge, once, in the order of the lower triangles beside them.
std::vector<std::array<std::int32_t, 2>> edges_of(const TriangleComplex& complex);

/// What breaks the invariants, a line each (at most 20).
std::vector<std::string> validate(const TriangleComplex& complex);

}  // namespace tetfarm
