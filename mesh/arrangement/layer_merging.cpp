#include "mesh/arrangement/layer_merging.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>

#include "base/array_index.h"
#include "base/disjoint_sets.h"
#include "mesh/arrangement/constrained_triangulation.h"
#include "mesh/arrangement/snap_rounding.h"
#include "mesh/geometry/box_tree.h"
#include "mesh/geometry/predicates.h"

namespace tetfarm {
namespace {

/// Joining vertices and leading edges through them moves faces off each other so far.
constexpr double layer_share = 8;

ChainEdge sorted_edge(std::int32_t a, std::int32_t b) { return {std::min(a, b), std::max(a, b)}; }

bool lies_near_plane_of(const TrianglePoints& corners, const TrianglePoints& plane,
                        double distance) {
  const Vec3 normal = cross(plane[1] - plane[0], plane[2] - plane[0]);
  const double most = distance * norm(normal);
  return std::ranges::all_of(
      corners, [&](const Vec3& p) { return std::abs(dot(normal, p - plane[0])) <= most; });
}

/// By the plane of the larger one: that of the smaller says little far away.
bool are_one_layer(const TrianglePoints& a, const TrianglePoints& b, double distance) {
  const auto area2 = [](const TrianglePoints& t) { return norm2(cross(t[1] - t[0], t[2] - t[0])); };
  return area2(a) > area2(b) ? lies_near_plane_of(b, a, distance)
                             : lies_near_plane_of(a, b, distance);
}

/// The triangles as they change, with those round each edge.
class LayerMerging {
 public:
  LayerMerging(TriangleChain& chain, double distance) : chain_(chain), distance_(distance) {
    is_gone_.assign(chain.triangles.size(), 0);
    layer_.assign(chain.triangles.size(), -1);
    for (std::size_t t = 0; t < chain.triangles.size(); ++t) add_to_edges(t);
  }

  std::int32_t gather_layers(const std::vector<TrianglePair>& pairs) {
    DisjointSets sets(chain_.triangles.size());
    std::vector<char> is_in_layer(chain_.triangles.size(), 0);
    for (const auto& [i, j] : pairs) {
      if (!are_one_layer(chain_.points_of(i), chain_.points_of(j), layer_share * distance_))
        continue;
      sets.join(at(i), at(j));
      is_in_layer[at(i)] = is_in_layer[at(j)] = 1;
    }
    const auto layers = groups_of_marked(sets, is_in_layer);
    for (std::size_t layer = 0; layer < layers.size(); ++layer) {
      for (const std::int32_t t : layers[layer]) layer_[at(t)] = static_cast<std::int32_t>(layer);
    }
    return static_cast<std::int32_t>(layers.size());
  }

  bool merge(std::int32_t layer) {
    std::vector<std::int32_t> members;
    for (std::size_t t = 0; t < layer_.size(); ++t) {
      if (layer_[t] == layer && is_gone_[t] == 0) members.push_back(static_cast<std::int32_t>(t));
    }
    const int axis = widest_axis(members);
    std::vector<ChainEdge> edges;
    for (const std::int32_t t : members) {
      for (std::size_t k = 0; k < 3; ++k) edges.push_back(edge_against(nodes_of(t), k));
    }
    std::ranges::sort(edges);
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    if (join_seen_together(edges, axis)) return true;
    const auto chains = snap_round(chain_.vertices, edges, axis, distance_ / 2);
    if (!chains) return false;
    std::map<ChainEdge, std::int32_t> border;
    for (const std::int32_t t : members) add_border(t, edges, *chains, border);
    const auto made = fill(members, border, axis);
    if (!made) return false;
    for (const std::int32_t t : members) is_gone_[at(t)] = 1;
    for (std::size_t e = 0; e < edges.size(); ++e) divide_outside(edges[e], (*chains)[e]);
    for (const ChainTriangle& t : *made) add(t, -1);
    return true;
  }

  void finish() {
    remove_triangles(chain_, is_gone_);
    join_vertices(chain_, joined_);
  }

 private:
  /// Vertices of the layer that are seen within the distance of each other are made one, later.
  bool join_seen_together(const std::vector<ChainEdge>& edges, int axis) {
    std::vector<std::int32_t> nodes;
    for (const ChainEdge& edge : edges) nodes.insert(nodes.end(), edge.begin(), edge.end());
    std::ranges::sort(nodes);
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    std::vector<Box3> boxes;
    for (const std::int32_t v : nodes) {
      Vec3 p = chain_.vertices[at(v)];
      p[axis] = 0;
      Box3 box;
      box.add(p - Vec3{distance_ / 2, distance_ / 2, distance_ / 2});
      box.add(p + Vec3{distance_ / 2, distance_ / 2, distance_ / 2});
      boxes.push_back(box);
    }
    const std::size_t before = joined_.size();
    BoxTree(boxes).self_pairs([&](std::int32_t i, std::int32_t j) {
      joined_.push_back({nodes[at(i)], nodes[at(j)]});
    });
    return joined_.size() > before;
  }

  const Triangle& nodes_of(std::int32_t t) const { return chain_.triangles[at(t)].nodes; }

  void add_to_edges(std::size_t t) {
    for (std::size_t k = 0; k < 3; ++k) {
      of_edge_[edge_against(chain_.triangles[t].nodes, k)].push_back(static_cast<std::int32_t>(t));
    }
  }

  void add(const ChainTriangle& t, std::int32_t layer) {
    chain_.triangles.push_back(t);
    is_gone_.push_back(0);
    layer_.push_back(layer);
    add_to_edges(chain_.triangles.size() - 1);
  }

  /// That along which the largest of them is widest.
  int widest_axis(const std::vector<std::int32_t>& members) const {
    Vec3 largest{0, 0, 0};
    for (const std::int32_t t : members) {
      const TrianglePoints p = chain_.points_of(t);
      const Vec3 normal = cross(p[1] - p[0], p[2] - p[0]);
      if (norm2(normal) > norm2(largest)) largest = normal;
    }
    const Vec3 size{std::abs(largest.x), std::abs(largest.y), std::abs(largest.z)};
    if (size.x >= size.y && size.x >= size.z) return 0;
    return size.y >= size.z ? 1 : 2;
  }

  /// How often the triangles of the layer have each piece of edge on their left, less than on their
  /// right, from its smaller to its larger number.
  void add_border(std::int32_t t, const std::vector<ChainEdge>& edges,
                  const std::vector<std::vector<std::int32_t>>& chains,
                  std::map<ChainEdge, std::int32_t>& border) const {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::int32_t from = nodes_of(t)[(k + 1) % 3];
      const ChainEdge edge = edge_against(nodes_of(t), k);
      const auto place = std::ranges::lower_bound(edges, edge) - edges.begin();
      const std::vector<std::int32_t>& chain = chains[static_cast<std::size_t>(place)];
      const std::int32_t way = from == edge[0] ? 1 : -1;
      for (std::size_t i = 1; i < chain.size(); ++i) {
        const bool is_up = chain[i - 1] < chain[i];
        border[sorted_edge(chain[i - 1], chain[i])] +=
            (is_up ? way : -way) * chain_.triangles[at(t)].times;
      }
    }
  }

  /// The triangles of the layer, each as often as the border winds round it.
  std::optional<std::vector<ChainTriangle>> fill(const std::vector<std::int32_t>& members,
                                                 const std::map<ChainEdge, std::int32_t>& border,
                                                 int axis) const {
    ExactPoints points;
    std::vector<std::int32_t> vertex_of;
    std::map<std::int32_t, std::int32_t> number_of;
    const auto number = [&](std::int32_t vertex) {
      const auto [entry, is_new] = number_of.try_emplace(vertex, -1);
      if (is_new) entry->second = points.add(exact_point(chain_.vertices[at(vertex)]));
      if (at(entry->second) == vertex_of.size()) vertex_of.push_back(vertex);
      return entry->second;
    };
    std::vector<Segment> segments;
    for (const auto& [edge, times] : border) {
      const std::int32_t from = number(edge[0]);
      segments.push_back({from, number(edge[1])});
    }
    std::vector<std::int32_t> nodes(vertex_of.size());
    for (std::size_t n = 0; n < nodes.size(); ++n) nodes[n] = static_cast<std::int32_t>(n);
    auto found = triangulate(points, nodes, segments, axis);
    if (!found) return std::nullopt;
    std::vector<Triangle>& pieces = *found;
    for (Triangle& piece : pieces) {
      for (std::int32_t& n : piece) n = vertex_of[at(n)];
    }
    const std::vector<std::int32_t> times = winding_of(pieces, border);
    std::vector<ChainTriangle> made;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      if (times[i] == 0) continue;
      ChainTriangle t{pieces[i], std::abs(times[i]), 0, true, false};
      t.patch = patch_under(pieces[i], times[i] > 0 ? 1 : -1, members, axis);
      if (times[i] < 0) std::swap(t.nodes[1], t.nodes[2]);
      made.push_back(t);
    }
    return made;
  }

  static std::vector<std::int32_t> winding_of(const std::vector<Triangle>& pieces,
                                              const std::map<ChainEdge, std::int32_t>& border) {
    std::map<ChainEdge, std::vector<std::int32_t>> of_edge;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        of_edge[edge_against(pieces[i], k)].push_back(static_cast<std::int32_t>(i));
      }
    }
    // What a piece has more than what is beyond its edge.
    const auto step = [&](const Triangle& piece, std::size_t k) {
      const ChainEdge edge = edge_against(piece, k);
      const auto found = border.find(edge);
      if (found == border.end()) return 0;
      return piece[(k + 1) % 3] == edge[0] ? found->second : -found->second;
    };
    std::vector<std::int32_t> times(pieces.size(), 0);
    std::vector<char> is_known(pieces.size(), 0);
    std::vector<std::int32_t> open;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        if (is_known[i] != 0 || of_edge[edge_against(pieces[i], k)].size() != 1) continue;
        times[i] = step(pieces[i], k);
        is_known[i] = 1;
        open.push_back(static_cast<std::int32_t>(i));
      }
    }
    while (!open.empty()) {
      const std::int32_t i = open.back();
      open.pop_back();
      for (std::size_t k = 0; k < 3; ++k) {
        for (const std::int32_t j : of_edge[edge_against(pieces[at(i)], k)]) {
          if (is_known[at(j)] != 0) continue;
          times[at(j)] = times[at(i)] - step(pieces[at(i)], k);
          is_known[at(j)] = 1;
          open.push_back(j);
        }
      }
    }
    return times;
  }

  /// Of the first member that faces so and lies under the middle of the piece; or else that faces
  /// so.
  std::int32_t patch_under(const Triangle& piece, int facing,
                           const std::vector<std::int32_t>& members, int axis) const {
    const auto seen = [&](const Vec3& p) { return Vec2{p[(axis + 1) % 3], p[(axis + 2) % 3]}; };
    const TrianglePoints corners = triangle_points(chain_.vertices, piece);
    const Vec2 middle = seen((corners[0] + corners[1] + corners[2]) / 3);
    std::int32_t patch = -1;
    for (const std::int32_t t : members) {
      const TrianglePoints p = chain_.points_of(t);
      const Vec2 a = seen(p[0]);
      const Vec2 b = seen(p[1]);
      const Vec2 c = seen(p[2]);
      if (orient2d(a, b, c) * facing * chain_.triangles[at(t)].times <= 0) continue;
      if (patch < 0) patch = chain_.triangles[at(t)].patch;
      const bool is_under = orient2d(a, b, middle) * facing >= 0 &&
                            orient2d(b, c, middle) * facing >= 0 &&
                            orient2d(c, a, middle) * facing >= 0;
      if (is_under) return chain_.triangles[at(t)].patch;
    }
    return std::max(patch, 0);
  }

  /// The triangles on an edge that are not of the layer get its points, too.
  void divide_outside(const ChainEdge& edge, const std::vector<std::int32_t>& points) {
    if (points.size() == 2) return;
    const std::vector<std::int32_t> round = of_edge_[edge];
    for (const std::int32_t t : round) {
      if (is_gone_[at(t)] != 0) continue;
      is_gone_[at(t)] = 1;
      std::vector<ChainTriangle> pieces;
      add_pieces(chain_.triangles[at(t)], edge, points, pieces);
      for (const ChainTriangle& piece : pieces) add(piece, layer_[at(t)]);
    }
  }

  TriangleChain& chain_;
  double distance_;
  std::vector<char> is_gone_;
  std::vector<std::int32_t> layer_;
  std::vector<ChainEdge> joined_;
  std::map<ChainEdge, std::vector<std::int32_t>> of_edge_;
};

}  // namespace

bool merge_layers(TriangleChain& chain, const std::vector<TrianglePair>& pairs, double distance) {
  LayerMerging merging(chain, distance);
  const std::int32_t layers = merging.gather_layers(pairs);
  bool has_merged = false;
  for (std::int32_t layer = 0; layer < layers; ++layer) has_merged |= merging.merge(layer);
  merging.finish();
  return has_merged;
}

}  // namespace tetfarm
