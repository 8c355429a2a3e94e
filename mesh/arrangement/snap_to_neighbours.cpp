#include "mesh/arrangement/snap_to_neighbours.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <utility>

#include "base/array_index.h"
#include "mesh/geometry/nearest_point.h"

namespace tetfarm {
namespace {

bool has(std::span<const std::int32_t> nodes, std::int32_t node) {
  return std::ranges::find(nodes, node) != nodes.end();
}

/// Where two segments come nearest to each other, if that is inside both and they are not parallel:
/// the shares of their lengths.
std::optional<std::array<double, 2>> nearest_inside(const Vec3& a, const Vec3& b, const Vec3& c,
                                                    const Vec3& d) {
  const Vec3 along = b - a;
  const Vec3 other = d - c;
  const double length2 = norm2(along);
  const double other2 = norm2(other);
  const double both = dot(along, other);
  const double sine2 = length2 * other2 - both * both;
  constexpr double least_sine2 = 1e-12;
  if (!(sine2 > least_sine2 * length2 * other2)) return std::nullopt;
  const Vec3 apart = c - a;
  const double share = (dot(apart, along) * other2 - dot(apart, other) * both) / sine2;
  const double other_share = (dot(apart, along) * both - dot(apart, other) * length2) / sine2;
  if (!(share > 0 && share < 1 && other_share > 0 && other_share < 1)) return std::nullopt;
  return std::array<double, 2>{share, other_share};
}

/// What is near what, of the triangles as they are.
struct NearThings {
  std::map<ChainEdge, std::vector<std::int32_t>> edge_divisions;  ///< at which vertices
  std::map<std::int32_t, std::int32_t> triangle_divisions;        ///< at which vertex
};

class NearSearch {
 public:
  NearSearch(TriangleChain& chain, double distance)
      : chain_(chain), distance2_(distance * distance) {}

  void look_at(const TrianglePair& pair) {
    const Triangle t = chain_.triangles[at(pair[0])].nodes;
    const Triangle u = chain_.triangles[at(pair[1])].nodes;
    const bool is_near_edge_of_u = find_vertices_at_edges(t, u);
    const bool is_near_edge_of_t = find_vertices_at_edges(u, t);
    if (is_near_edge_of_u || is_near_edge_of_t) return;
    if (find_edges(t, u)) return;
    find_vertex_at_face(t, pair[1]);
    find_vertex_at_face(u, pair[0]);
  }

  const NearThings& found() const { return found_; }

 private:
  const Vec3& point(std::int32_t v) const { return chain_.vertices[at(v)]; }
  bool is_near(const Vec3& p, const Vec3& q) const { return norm2(p - q) <= distance2_; }

  bool find_vertices_at_edges(const Triangle& t, const Triangle& u) {
    bool found = false;
    for (const std::int32_t v : t) {
      if (has(u, v)) continue;
      for (std::size_t k = 0; k < 3; ++k) {
        const ChainEdge edge = edge_against(u, k);
        const Vec3 foot = nearest_on_segment(point(v), point(edge[0]), point(edge[1]));
        if (!is_near(point(v), foot)) continue;
        found_.edge_divisions[edge].push_back(v);
        found = true;
      }
    }
    return found;
  }

  bool find_edges(const Triangle& t, const Triangle& u) {
    bool found = false;
    for (std::size_t k = 0; k < 3; ++k) {
      for (std::size_t l = 0; l < 3; ++l) {
        const ChainEdge e = edge_against(t, k);
        const ChainEdge f = edge_against(u, l);
        if (!has(e, f[0]) && !has(e, f[1]) && divide_both(e, f)) found = true;
      }
    }
    return found;
  }

  bool divide_both(const ChainEdge& e, const ChainEdge& f) {
    const auto shares = nearest_inside(point(e[0]), point(e[1]), point(f[0]), point(f[1]));
    if (!shares) return false;
    const Vec3 on_e = point(e[0]) + (*shares)[0] * (point(e[1]) - point(e[0]));
    const Vec3 on_f = point(f[0]) + (*shares)[1] * (point(f[1]) - point(f[0]));
    if (!is_near(on_e, on_f)) return false;
    if (!divided_.insert({std::min(e, f), std::max(e, f)}).second) return true;
    const auto made = static_cast<std::int32_t>(chain_.vertices.size());
    chain_.vertices.push_back(0.5 * (on_e + on_f));
    found_.edge_divisions[e].push_back(made);
    found_.edge_divisions[f].push_back(made);
    return true;
  }

  void find_vertex_at_face(const Triangle& t, std::int32_t face) {
    const Triangle& u = chain_.triangles[at(face)].nodes;
    for (const std::int32_t v : t) {
      if (has(u, v)) continue;
      const Vec3 foot = nearest_on_triangle(point(v), point(u[0]), point(u[1]), point(u[2]));
      if (is_near(point(v), foot)) found_.triangle_divisions.emplace(face, v);
    }
  }

  TriangleChain& chain_;
  double distance2_;
  NearThings found_;
  std::set<std::array<ChainEdge, 2>> divided_;
};

/// Divides triangles one after the other; each edge and each triangle once.
class Divider {
 public:
  explicit Divider(TriangleChain& chain) : chain_(chain), is_touched_(chain.triangles.size(), 0) {
    for (std::size_t t = 0; t < chain.triangles.size(); ++t) {
      for (std::size_t k = 0; k < 3; ++k) {
        of_edge_[edge_against(chain.triangles[t].nodes, k)].push_back(static_cast<std::int32_t>(t));
      }
    }
  }

  /// At vertices near it, in their order along it; false where a triangle on it was divided before.
  bool divide_edge(const ChainEdge& edge, std::vector<std::int32_t> vertices) {
    const std::vector<std::int32_t>& round = of_edge_[edge];
    if (std::ranges::any_of(round, [&](std::int32_t t) { return is_touched_[at(t)] != 0; })) {
      return false;
    }
    const Vec3& from = chain_.vertices[at(edge[0])];
    const Vec3 along = chain_.vertices[at(edge[1])] - from;
    std::ranges::sort(vertices);
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    std::ranges::stable_sort(
        vertices, {}, [&](std::int32_t v) { return dot(chain_.vertices[at(v)] - from, along); });
    vertices.insert(vertices.begin(), edge[0]);
    vertices.push_back(edge[1]);
    for (const std::int32_t t : round) {
      is_touched_[at(t)] = 1;
      add_pieces(chain_.triangles[at(t)], edge, vertices, made_);
    }
    return !round.empty();
  }

  bool divide_triangle(std::int32_t t, std::int32_t vertex) {
    if (is_touched_[at(t)] != 0) return false;
    is_touched_[at(t)] = 1;
    for (std::size_t k = 0; k < 3; ++k) {
      ChainTriangle third = chain_.triangles[at(t)];
      third.nodes[k] = vertex;
      third.is_divided = true;
      third.is_clear = false;
      made_.push_back(third);
    }
    return true;
  }

  void finish() {
    remove_triangles(chain_, is_touched_);
    chain_.triangles.insert(chain_.triangles.end(), made_.begin(), made_.end());
  }

 private:
  TriangleChain& chain_;
  std::map<ChainEdge, std::vector<std::int32_t>> of_edge_;
  std::vector<char> is_touched_;  // divided, or gone
  std::vector<ChainTriangle> made_;
};

}  // namespace

std::int64_t join_near_vertices(TriangleChain& chain, const std::vector<TrianglePair>& pairs,
                                double distance) {
  std::vector<ChainEdge> near;
  for (const auto& [i, j] : pairs) {
    for (const std::int32_t v : chain.triangles[at(i)].nodes) {
      for (const std::int32_t w : chain.triangles[at(j)].nodes) {
        const Vec3 apart = chain.vertices[at(v)] - chain.vertices[at(w)];
        if (v != w && norm2(apart) <= distance * distance) near.push_back({v, w});
      }
    }
  }
  join_vertices(chain, near);
  return static_cast<std::int64_t>(near.size());
}

std::int64_t snap_to_neighbours(TriangleChain& chain, const std::vector<TrianglePair>& pairs,
                                double distance) {
  NearSearch search(chain, distance);
  for (const TrianglePair& pair : pairs) search.look_at(pair);
  const NearThings& near = search.found();
  std::int64_t changes = 0;
  Divider divider(chain);
  for (const auto& [edge, vertices] : near.edge_divisions) {
    if (divider.divide_edge(edge, vertices)) ++changes;
  }
  for (const auto& [triangle, vertex] : near.triangle_divisions) {
    if (divider.divide_triangle(triangle, vertex)) ++changes;
  }
  divider.finish();
  return changes;
}

}  // namespace tetfarm
