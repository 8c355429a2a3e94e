#include "mesh/recovery/facet_flips.h"

#include <algorithm>
#include <array>
#include <deque>
#include <optional>

#include "base/check.h"
#include "mesh/recovery/edge_recovery.h"
#include "mesh/recovery/kernel_point.h"
#include "mesh/recovery/recovery_guard.h"
#include "mesh/recovery/ring_triangulation.h"

namespace tetfarm {
namespace {

using Edge = std::array<std::int32_t, 2>;

int sign(double x) { return (x > 0) - (x < 0); }

/// The plane of the missing edge ab and the edges that it crosses. Sides of lines in it are told
/// from a node beside the plane.
class Facet {
 public:
  /// x lies in the plane, beside the line ab; `beside` not in the plane.
  Facet(const LocalRemeshing& mesh, const Edge& edge, std::int32_t x, std::int32_t beside)
      : mesh_(mesh), edge_(edge), x_(x), beside_(beside) {}

  bool holds(std::int32_t node) const { return mesh_.orient(edge_[0], edge_[1], x_, node) == 0; }
  /// On which side of the line from p to q the node lies: -1, 0, 1. All three are in the plane.
  int side(std::int32_t p, std::int32_t q, std::int32_t node) const {
    return sign(mesh_.orient(p, q, node, beside_));
  }
  bool cross(const Edge& e, const Edge& f) const {
    return side(e[0], e[1], f[0]) * side(e[0], e[1], f[1]) < 0 &&
           side(f[0], f[1], e[0]) * side(f[0], f[1], e[1]) < 0;
  }

 private:
  const LocalRemeshing& mesh_;
  Edge edge_;
  std::int32_t x_;
  std::int32_t beside_;
};

/// Where in the ring of an edge the two nodes are with which it makes triangles in the plane.
using Wings = std::array<std::size_t, 2>;

std::optional<Wings> wings(const Facet& facet, const EdgeRing& ring) {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < ring.apexes.size(); ++i) {
    if (facet.holds(ring.apexes[i])) found.push_back(i);
  }
  if (found.size() != 2) return std::nullopt;
  return Wings{found[0], found[1]};
}

/// Swaps edges of the complex inside a plane.
class FacetFlips {
 public:
  FacetFlips(LocalRemeshing& mesh, const RecoverySurface& surface,
             std::vector<std::int32_t>& inside)
      : mesh_(mesh), surface_(surface), inside_(inside) {}

  bool is_fixed(std::int32_t u, std::int32_t v) const {
    return std::max(u, v) >= surface_.nodes() || surface_.has_edge(u, v);
  }

  /// The edge of the ring becomes the one between its wings. False: nothing has changed.
  bool swap(const EdgeRing& ring, const Edge& edge, const Wings& wing) {
    if (mesh_.has_constraint(ring)) return false;
    const std::size_t mark = mesh_.mark();
    const std::size_t points = inside_.size();
    std::vector<Tet> tets;
    const auto [i, j] = wing;
    if (fill(part(ring, i, j), edge, tets) && fill(part(ring, j, i), edge, tets)) {
      mesh_.replace(ring.tets, tets);
      return true;
    }
    mesh_.roll_back(mark);
    inside_.resize(points);
    return false;
  }

 private:
  /// The apexes from the i-th on to the j-th: what lies on one side of the plane.
  static EdgeRing part(const EdgeRing& ring, std::size_t i, std::size_t j) {
    EdgeRing side;
    TF_CHECK(i < ring.apexes.size() && j < ring.apexes.size());
    for (std::size_t k = i;; k = (k + 1) % ring.apexes.size()) {
      side.apexes.push_back(ring.apexes[k]);
      if (k == j) return side;
    }
  }

  /// Tets for one side of the plane.
  bool fill(const EdgeRing& side, const Edge& edge, std::vector<Tet>& tets) {
    const auto [u, v] = edge;
    const auto found = ring_triangulation(mesh_, side, u, v, -1, RecoveryGuard::of_nothing(mesh_));
    if (!found) return fill_with_point(side, edge, tets);
    const std::vector<Tet> cut = tets_of(*found, side, u, v);
    tets.insert(tets.end(), cut.begin(), cut.end());
    return true;
  }

  /// The triangles that a point on one side of the plane has to see.
  static std::vector<Triangle> shell(const EdgeRing& side, const Edge& edge) {
    const auto [u, v] = edge;
    std::vector<Triangle> faces;
    for (std::size_t k = 0; k + 1 < side.apexes.size(); ++k) {
      const std::int32_t p = side.apexes[k], q = side.apexes[k + 1];
      faces.push_back({v, q, p});
      faces.push_back({u, p, q});
    }
    const std::int32_t c = side.apexes.front(), d = side.apexes.back();
    faces.push_back({c, d, v});
    faces.push_back({d, c, u});
    return faces;
  }

  bool fill_with_point(const EdgeRing& side, const Edge& edge, std::vector<Tet>& tets) {
    const std::vector<Triangle> faces = shell(side, edge);
    std::vector<VisibleFace> seen;
    for (const auto& [p, q, r] : faces) {
      seen.push_back({mesh_.fine_point(p), mesh_.fine_point(q), mesh_.fine_point(r)});
    }
    constexpr DoubleDouble half = {0.5, 0};
    const FinePoint start = between(mesh_.fine_point(edge[0]), mesh_.fine_point(edge[1]), half);
    const auto place = kernel_point(seen, start);
    if (!place) return false;
    const std::int32_t node = mesh_.add_point(*place);
    inside_.push_back(node);
    for (const auto& [p, q, r] : faces) {
      if (mesh_.orient(p, q, r, node) <= 0) return false;
      tets.push_back({p, q, r, node});
    }
    return true;
  }

  LocalRemeshing& mesh_;
  const RecoverySurface& surface_;
  std::vector<std::int32_t>& inside_;
};

/// The edges that ab crosses, from a to b, when each lies in one plane with the next.
struct FacetWalk {
  Facet facet;
  std::deque<Edge> crossed;
};

/// A node of the ring that is not in the plane of ab and x; -1 when there is none.
std::int32_t node_beside(const LocalRemeshing& mesh, const Edge& edge, std::int32_t x,
                         const EdgeRing& ring) {
  for (const std::int32_t apex : ring.apexes) {
    if (mesh.orient(edge[0], edge[1], x, apex) != 0) return apex;
  }
  return -1;
}

std::optional<FacetWalk> walk_facet(const LocalRemeshing& mesh, const FacetFlips& flips,
                                    const Edge& edge) {
  const SegmentWalk walk = walk_segment(mesh, edge[0], edge[1]);
  if (walk.crossings.size() != 1 || walk.crossings[0].face != no_face) return std::nullopt;
  Edge next = walk.crossings[0].edge;
  auto ring = mesh.ring(next[0], next[1]);
  if (!ring) return std::nullopt;
  const std::int32_t beside = node_beside(mesh, edge, next[0], *ring);
  if (beside < 0) return std::nullopt;
  FacetWalk result{Facet(mesh, edge, next[0], beside), {}};
  const Facet& facet = result.facet;
  const int first_side = facet.side(edge[0], edge[1], next[0]);
  std::int32_t behind = edge[0];
  constexpr std::size_t most_edges = 1000;
  while (result.crossed.size() < most_edges) {
    if (flips.is_fixed(next[0], next[1])) return std::nullopt;
    result.crossed.push_back(next);
    ring = mesh.ring(next[0], next[1]);
    if (!ring) return std::nullopt;
    const auto wing = wings(facet, *ring);
    if (!wing) return std::nullopt;
    const std::int32_t c = ring->apexes[(*wing)[0]], d = ring->apexes[(*wing)[1]];
    if (c != behind && d != behind) return std::nullopt;
    const std::int32_t ahead = c == behind ? d : c;
    if (ahead == edge[1]) return result;
    const int side = facet.side(edge[0], edge[1], ahead);
    if (side == 0) return std::nullopt;
    // next[0] stays on the side where it was at first.
    behind = side == first_side ? next[0] : next[1];
    (side == first_side ? next[0] : next[1]) = ahead;
  }
  return std::nullopt;
}

}  // namespace

bool recover_edge_in_facet(LocalRemeshing& mesh, const RecoverySurface& surface, std::int32_t a,
                           std::int32_t b, std::vector<std::int32_t>& inside) {
  const Edge edge = {a, b};
  FacetFlips flips(mesh, surface, inside);
  auto walk = walk_facet(mesh, flips, edge);
  if (!walk) return false;
  const Facet& facet = walk->facet;
  std::deque<Edge>& crossed = walk->crossed;
  const std::size_t mark = mesh.mark();
  const std::size_t points = inside.size();
  // Swapped edges that still cross go to the end: each time round at least one leaves.
  for (std::size_t left = 4 * crossed.size() * crossed.size() + 4; left > 0; --left) {
    if (crossed.empty()) {
      mesh.forget_journal();
      return true;
    }
    const Edge next = crossed.front();
    crossed.pop_front();
    const auto ring = mesh.ring(next[0], next[1]);
    if (!ring) break;
    const auto wing = wings(facet, *ring);
    if (!wing) break;
    const Edge other = {ring->apexes[(*wing)[0]], ring->apexes[(*wing)[1]]};
    if (!facet.cross(next, other)) {
      crossed.push_back(next);
      continue;
    }
    if (!flips.swap(*ring, next, *wing)) break;
    if (facet.cross(other, edge)) crossed.push_back(other);
  }
  mesh.roll_back(mark);
  TF_CHECK(points <= inside.size());
  inside.resize(points);
  return false;
}

}  // namespace tetfarm
