#include "mesh/adaptation/curve_tracing.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <unordered_map>

#include "base/array_index.h"
#include "base/error.h"
#include "mesh/adaptation/checked_plane_mesh.h"
#include "mesh/adaptation/metric_mesh.h"

namespace tetfarm {
namespace {

struct NamedEdge {
  std::int32_t patch = 0;
  bool is_there = false;  ///< as the side of a triangle
};

/// @throws InvalidInput for the first edge of the mesh that is no side of a triangle.
void check_named_edges(const PlaneMesh& mesh,
                       const std::unordered_map<std::uint64_t, NamedEdge>& named) {
  for (std::size_t k = 0; k < mesh.edges.size(); ++k) {
    const auto [a, b] = mesh.edges[k];
    if (named.at(edge_key(a, b)).is_there) continue;
    const bool is_node = a >= 0 && at(a) < mesh.points.size();
    throw InvalidInput("nodes " + std::to_string(a + 1) + " and " + std::to_string(b + 1) +
                           " are not joined by the side of a triangle" +
                           (is_node ? "; at " + place_text(mesh.points[at(a)]) : ""),
                       in_file(mesh.name, "edge " + std::to_string(k + 1)));
  }
}

/// Goes from corner to corner.
class PieceTracing {
 public:
  PieceTracing(const PlaneMesh& mesh, const std::vector<HeldEdge>& held, double corner_angle_deg)
      : held_(held), is_used_(held.size(), false), is_corner_(mesh.points.size(), false) {
    for (std::size_t k = 0; k < held.size(); ++k) {
      for (const std::int32_t v : held[k].nodes) edges_at_[v].push_back(k);
    }
    const double least_cosine = std::cos(corner_angle_deg * std::numbers::pi / 180);
    for (const auto& [node, edges] : edges_at_) {
      is_corner_[at(node)] = is_corner(mesh, node, edges, least_cosine);
    }
    for (const std::int32_t v : mesh.corners) {
      if (v >= 0 && at(v) < mesh.points.size()) is_corner_[at(v)] = true;
    }
  }

  TracedBoundary trace() {
    TracedBoundary traced;
    for (const bool from_corners : {true, false}) {
      for (std::size_t k = 0; k < held_.size(); ++k) {
        if (is_used_[k]) continue;
        const auto [a, b] = held_[k].nodes;
        if (from_corners && !is_corner_[at(a)] && !is_corner_[at(b)]) continue;
        traced.pieces.push_back(follow(k, from_corners && !is_corner_[at(a)] ? b : a));
      }
    }
    for (std::size_t v = 0; v < is_corner_.size(); ++v) {
      if (is_corner_[v]) traced.corners.push_back(static_cast<std::int32_t>(v));
    }
    return traced;
  }

 private:
  std::int32_t other_end(std::size_t edge, std::int32_t node) const {
    const auto& ends = held_[edge].nodes;
    return ends[0] == node ? ends[1] : ends[0];
  }

  bool is_corner(const PlaneMesh& mesh, std::int32_t node, const std::vector<std::size_t>& edges,
                 double least_cosine) const {
    if (edges.size() != 2 || held_[edges[0]].patch != held_[edges[1]].patch) return true;
    return turns_by_more(mesh.points[at(other_end(edges[0], node))], mesh.points[at(node)],
                         mesh.points[at(other_end(edges[1], node))], least_cosine);
  }

  /// The piece that begins at `start` with the edge.
  BoundaryPiece follow(std::size_t edge, std::int32_t start) {
    BoundaryPiece piece;
    piece.patch = held_[edge].patch;
    piece.nodes.push_back(start);
    for (;;) {
      is_used_[edge] = true;
      const std::int32_t node = other_end(edge, piece.nodes.back());
      piece.nodes.push_back(node);
      if (node == start || is_corner_[at(node)]) break;
      const std::vector<std::size_t>& edges = edges_at_[node];
      edge = edges[0] == edge ? edges[1] : edges[0];
    }
    piece.is_closed = piece.nodes.back() == start && !is_corner_[at(start)];
    if (piece.is_closed) piece.nodes.pop_back();
    return piece;
  }

  const std::vector<HeldEdge>& held_;
  std::vector<bool> is_used_;
  std::vector<bool> is_corner_;
  std::unordered_map<std::int32_t, std::vector<std::size_t>> edges_at_;
};

}  // namespace

std::vector<HeldEdge> hold_edges(const PlaneMesh& mesh, TriangleComplex& complex) {
  std::unordered_map<std::uint64_t, NamedEdge> named;
  for (std::size_t k = 0; k < mesh.edges.size(); ++k) {
    named[edge_key(mesh.edges[k][0], mesh.edges[k][1])].patch = mesh.patches[k];
  }
  std::vector<HeldEdge> held;
  // Sides are looked up, not edges by find_edge(), which sees one fan of a node where two parts
  // meet.
  for (std::int32_t t = 0; t < complex.size(); ++t) {
    for (int i = 0; i < 3; ++i) {
      const EdgeHandle other = complex.neighbour(t, i);
      if (other != no_edge && triangle_of(other) < t) continue;
      const std::array<std::int32_t, 2> edge{complex.node(t, next(i)),
                                             complex.node(t, previous(i))};
      const auto name = named.find(edge_key(edge[0], edge[1]));
      const bool is_named = name != named.end();
      if (is_named) name->second.is_there = true;
      const bool parts_regions = other != no_edge && !mesh.regions.empty() &&
                                 mesh.regions[at(t)] != mesh.regions[at(triangle_of(other))];
      if (is_named || parts_regions) complex.constrain(edge_handle(t, i), true);
      if (!complex.is_constrained(t, i)) continue;
      held.push_back({edge, is_named ? name->second.patch : 0});
    }
  }
  check_named_edges(mesh, named);
  return held;
}

TracedBoundary trace_boundary(const PlaneMesh& mesh, const std::vector<HeldEdge>& held,
                              double corner_angle_deg) {
  return PieceTracing(mesh, held, corner_angle_deg).trace();
}

bool turns_by_more(const Vec2& before, const Vec2& corner, const Vec2& after, double cosine) {
  const Vec2 in{corner.x - before.x, corner.y - before.y};
  const Vec2 out{after.x - corner.x, after.y - corner.y};
  const double lengths = std::hypot(in.x, in.y) * std::hypot(out.x, out.y);
  return in.x * out.x + in.y * out.y < cosine * lengths;
}

}  // namespace tetfarm
