/// Joins the edges of a mesh that are held to pieces between corners.
///
/// A corner is a node where held edges of two patches meet, or other than two, or two that turn by
/// more than an angle; between corners the edges of a patch are one piece. Edges between triangles
/// of two regions are held like those of the boundary.
/// Determinism: pieces come in the order of their first edges in the complex. Cost: O(edges).
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "mesh/planar/plane_mesh.h"
#include "mesh/planar/triangle_complex.h"

namespace tetfarm {

struct HeldEdge {
  std::array<std::int32_t, 2> nodes{};
  std::int32_t patch = 0;
};

/// The edges that are held, which become constrained; those that the mesh does not name have
/// patch 0. @throws InvalidInput when an edge of the mesh is no edge of a triangle.
std::vector<HeldEdge> hold_edges(const PlaneMesh& mesh, TriangleComplex& complex);

struct BoundaryPiece {
  std::vector<std::int32_t> nodes;  ///< in order; of a loop with one corner that comes twice
  bool is_closed = false;           ///< without corners: the first follows the last
  std::int32_t patch = 0;
};

struct TracedBoundary {
  std::vector<BoundaryPiece> pieces;
  std::vector<std::int32_t> corners;  ///< ascending; those that the mesh names too
};

TracedBoundary trace_boundary(const PlaneMesh& mesh, const std::vector<HeldEdge>& held,
                              double corner_angle_deg);

/// Whether the way from `before` over `corner` to `after` turns by more than the angle.
bool turns_by_more(const Vec2& before, const Vec2& corner, const Vec2& after, double cosine);

}  // namespace tetfarm
