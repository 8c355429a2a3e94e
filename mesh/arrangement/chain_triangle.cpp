#include "mesh/arrangement/chain_triangle.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "base/array_index.h"
#include "base/check.h"
#include "mesh/geometry/box_tree.h"

namespace tetfarm {

ChainEdge edge_against(const Triangle& nodes, std::size_t corner) {
  const std::int32_t a = nodes[(corner + 1) % 3];
  const std::int32_t b = nodes[(corner + 2) % 3];
  return {std::min(a, b), std::max(a, b)};
}

void add_pieces(const ChainTriangle& whole, const ChainEdge& edge,
                const std::vector<std::int32_t>& points, std::vector<ChainTriangle>& pieces) {
  const auto from = std::ranges::find(whole.nodes, edge[0]) - whole.nodes.begin();
  const auto to = std::ranges::find(whole.nodes, edge[1]) - whole.nodes.begin();
  for (std::size_t i = 1; i < points.size(); ++i) {
    ChainTriangle piece = whole;
    piece.is_divided = true;
    piece.is_clear = false;
    piece.nodes[at(from)] = points[i - 1];
    piece.nodes[at(to)] = points[i];
    const Triangle& n = piece.nodes;
    if (n[0] != n[1] && n[1] != n[2] && n[2] != n[0]) pieces.push_back(piece);
  }
}

void remove_triangles(TriangleChain& chain, const std::vector<char>& is_gone) {
  TF_CHECK(is_gone.size() == chain.triangles.size());
  std::size_t kept = 0;
  for (std::size_t t = 0; t < is_gone.size(); ++t) {
    if (is_gone[t] == 0) chain.triangles[kept++] = chain.triangles[t];
  }
  chain.triangles.resize(kept);
}

void merge_equals(TriangleChain& chain) {
  std::vector<std::int32_t> order(chain.vertices.size());
  for (std::size_t v = 0; v < order.size(); ++v) order[v] = static_cast<std::int32_t>(v);
  const auto coordinates = [&](std::int32_t v) {
    const Vec3& p = chain.vertices[at(v)];
    return std::array<double, 3>{p.x, p.y, p.z};
  };
  std::ranges::stable_sort(order, {}, coordinates);
  std::vector<std::int32_t> first_equal(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool is_equal = i > 0 && coordinates(order[i]) == coordinates(order[i - 1]);
    first_equal[at(order[i])] = is_equal ? first_equal[at(order[i - 1])] : order[i];
  }
  std::vector<std::pair<Triangle, std::int32_t>> sorted;
  for (std::size_t t = 0; t < chain.triangles.size(); ++t) {
    Triangle& nodes = chain.triangles[t].nodes;
    for (std::int32_t& n : nodes) n = first_equal[at(n)];
    if (is_degenerate(triangle_points(chain.vertices, nodes))) continue;
    Triangle corners = nodes;
    std::ranges::sort(corners);
    sorted.emplace_back(corners, static_cast<std::int32_t>(t));
  }
  std::ranges::sort(sorted);
  const auto is_even = [&](const Triangle& corners, const Triangle& nodes) {
    const auto low = std::ranges::find(nodes, corners[0]) - nodes.begin();
    return nodes[static_cast<std::size_t>((low + 1) % 3)] == corners[1];
  };
  std::vector<std::int32_t> times(chain.triangles.size(), 0);
  for (std::size_t i = 0; i < sorted.size();) {
    std::size_t end = i;
    std::int32_t sum = 0;
    for (; end < sorted.size() && sorted[end].first == sorted[i].first; ++end) {
      const ChainTriangle& t = chain.triangles[at(sorted[end].second)];
      sum += is_even(sorted[end].first, t.nodes) ? t.times : -t.times;
    }
    for (std::size_t j = i; sum != 0 && j < end; ++j) {
      const ChainTriangle& t = chain.triangles[at(sorted[j].second)];
      const std::int32_t as_it_faces = is_even(sorted[j].first, t.nodes) ? sum : -sum;
      if (as_it_faces < 0 || t.times < 0) continue;
      times[at(sorted[j].second)] = as_it_faces;
      break;
    }
    i = end;
  }
  std::vector<ChainTriangle> kept;
  for (std::size_t t = 0; t < times.size(); ++t) {
    if (times[t] == 0) continue;
    kept.push_back(chain.triangles[t]);
    kept.back().times = times[t];
  }
  chain.triangles = std::move(kept);
}

void join_vertices(TriangleChain& chain, const std::vector<ChainEdge>& pairs) {
  if (pairs.empty()) return;
  DisjointSets sets(chain.vertices.size());
  for (const auto& [v, w] : pairs) sets.join(at(v), at(w));
  std::vector<std::int32_t> first(chain.vertices.size(), -1);
  for (std::size_t v = 0; v < first.size(); ++v) {
    std::int32_t& of_set = first[sets.root(v)];
    if (of_set < 0) of_set = static_cast<std::int32_t>(v);
  }
  for (ChainTriangle& t : chain.triangles) {
    const Triangle before = t.nodes;
    for (std::int32_t& n : t.nodes) n = first[sets.root(at(n))];
    if (t.nodes == before) continue;
    t.is_divided = true;
    t.is_clear = false;
  }
}

std::vector<std::vector<std::int32_t>> groups_of_marked(DisjointSets& sets,
                                                        const std::vector<char>& is_marked) {
  std::vector<std::vector<std::int32_t>> groups;
  std::vector<std::int32_t> group_of_root(is_marked.size(), -1);
  for (std::size_t item = 0; item < is_marked.size(); ++item) {
    if (is_marked[item] == 0) continue;
    std::int32_t& group = group_of_root[sets.root(item)];
    if (group < 0) {
      group = static_cast<std::int32_t>(groups.size());
      groups.emplace_back();
    }
    groups[at(group)].push_back(static_cast<std::int32_t>(item));
  }
  return groups;
}

std::optional<std::vector<TrianglePair>> meeting_pairs(TriangleChain& chain) {
  std::vector<Triangle> triangles;
  for (const ChainTriangle& t : chain.triangles) triangles.push_back(t.nodes);
  const std::size_t most = 200'000 + 10 * triangles.size();
  const BoxTree tree(triangle_boxes(chain.vertices, triangles));
  std::vector<TrianglePair> pairs;
  tree.self_pairs([&](std::int32_t i, std::int32_t j) {
    if (pairs.size() > most) return;
    if (chain.triangles[at(i)].is_clear && chain.triangles[at(j)].is_clear) return;
    if (triangles_meet_beyond_shared(chain.vertices, triangles[at(i)], triangles[at(j)])) {
      pairs.push_back({i, j});
    }
  });
  if (pairs.size() > most) return std::nullopt;
  std::ranges::sort(pairs);
  for (ChainTriangle& t : chain.triangles) t.is_clear = true;
  for (const TrianglePair& pair : pairs) {
    for (const std::int32_t t : pair) chain.triangles[at(t)].is_clear = false;
  }
  return pairs;
}

}  // namespace tetfarm
