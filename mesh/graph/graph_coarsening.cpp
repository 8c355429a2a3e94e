#include "mesh/graph/graph_coarsening.h"

#include <algorithm>
#include <array>

#include "base/array_index.h"
#include "base/check.h"

namespace tetfarm {
namespace {

constexpr std::int32_t none = -1;
/// A level that keeps more of its nodes than this is not worth its memory.
constexpr double hardly_coarser = 0.95;
/// The heaviest node may have so many times the mean weight that is wanted.
constexpr std::int64_t heaviest_over_wanted = 2;

/// Fibonacci hashing.
std::uint32_t scrambled(std::size_t v) {
  return static_cast<std::uint32_t>((static_cast<std::uint64_t>(v) * 0x9E3779B97F4A7C15u) >> 32);
}

std::vector<std::int32_t> order_of_visits(const GraphLevel& level) {
  struct Visit {
    std::int32_t weight;
    std::uint32_t scrambled;
    std::int32_t node;
  };
  std::vector<Visit> visits;
  visits.reserve(level.movable);
  for (std::size_t v = 0; v < level.movable; ++v) {
    visits.push_back({level.graph.weight[v], scrambled(v), static_cast<std::int32_t>(v)});
  }
  std::sort(visits.begin(), visits.end(), [](const Visit& a, const Visit& b) {
    if (a.weight != b.weight) return a.weight < b.weight;
    return a.scrambled != b.scrambled ? a.scrambled < b.scrambled : a.node < b.node;
  });
  std::vector<std::int32_t> order;
  order.reserve(visits.size());
  for (const Visit& visit : visits) order.push_back(visit.node);
  return order;
}

/// The neighbour that v is best joined with, or none: the largest square of the edge over the
/// weight of the neighbour.
std::int32_t best_mate(const GraphLevel& level, std::size_t v, std::int64_t heaviest,
                       const std::vector<std::int32_t>& mate) {
  const WeightedGraph& graph = level.graph;
  std::int32_t best = none;
  double best_score = 0;
  for (std::size_t e = graph.begin(v); e < graph.end(v); ++e) {
    const std::int32_t w = graph.neighbour[e];
    if (at(w) >= level.movable || mate[at(w)] != none) continue;
    const std::int64_t together = std::int64_t{graph.weight[v]} + graph.weight[at(w)];
    if (together > heaviest) continue;
    const double edge = graph.edge_weight[e];
    const double score = edge * edge / graph.weight[at(w)];
    const bool is_better = best == none || score > best_score ||
                           (score == best_score && scrambled(at(w)) < scrambled(at(best)));
    if (is_better) {
      best = w;
      best_score = score;
    }
  }
  return best;
}

/// Of each node its pair's number in the coarser graph: pairs by their first nodes, then those that
/// do not move.
std::vector<std::int32_t> join_in_pairs(const GraphLevel& level, std::int64_t heaviest,
                                        std::size_t& movable) {
  std::vector<std::int32_t> mate(level.graph.size(), none);
  for (const std::int32_t v : order_of_visits(level)) {
    if (mate[at(v)] != none) continue;
    const std::int32_t w = best_mate(level, at(v), heaviest, mate);
    mate[at(v)] = w == none ? v : w;
    if (w != none) mate[at(w)] = v;
  }
  std::vector<std::int32_t> coarse_of(level.graph.size(), none);
  std::int32_t next = 0;
  for (std::size_t v = 0; v < level.graph.size(); ++v) {
    if (v == level.movable) movable = at(next);
    const bool is_second = v < level.movable && at(mate[v]) < v;
    coarse_of[v] = is_second ? coarse_of[at(mate[v])] : next++;
  }
  if (level.movable == level.graph.size()) movable = at(next);
  return coarse_of;
}

/// The coarser graph: edges between the same two nodes become one.
WeightedGraph contracted(const WeightedGraph& fine, const std::vector<std::int32_t>& coarse_of) {
  WeightedGraph coarse;
  const std::size_t nodes =
      coarse_of.empty() ? 0 : at(*std::max_element(coarse_of.begin(), coarse_of.end())) + 1;
  std::vector<std::array<std::int32_t, 2>> fine_of(nodes, {none, none});
  TF_CHECK(coarse_of.size() == fine.size());
  for (std::size_t v = 0; v < fine.size(); ++v) {
    std::array<std::int32_t, 2>& here = fine_of[at(coarse_of[v])];
    TF_CHECK(here[1] == none);  // a pair at most
    here[here[0] == none ? 0 : 1] = static_cast<std::int32_t>(v);
  }
  std::vector<std::int32_t> place(nodes, none);  // of the edge to that node, while in its row
  for (std::size_t c = 0; c < nodes; ++c) {
    std::int32_t weight = 0;
    const std::size_t begin = coarse.neighbour.size();
    for (const std::int32_t v : fine_of[c]) {
      if (v == none) continue;
      weight += fine.weight[at(v)];
      for (std::size_t e = fine.begin(at(v)); e < fine.end(at(v)); ++e) {
        const std::int32_t to = coarse_of[at(fine.neighbour[e])];
        if (at(to) == c) continue;
        if (place[at(to)] == none) {
          place[at(to)] = static_cast<std::int32_t>(coarse.neighbour.size());
          coarse.neighbour.push_back(to);
          coarse.edge_weight.push_back(0);
        }
        coarse.edge_weight[at(place[at(to)])] += fine.edge_weight[e];
      }
    }
    for (std::size_t e = begin; e < coarse.neighbour.size(); ++e) {
      place[at(coarse.neighbour[e])] = none;
    }
    coarse.first.push_back(static_cast<std::int32_t>(coarse.neighbour.size()));
    coarse.weight.push_back(weight);
  }
  return coarse;
}

}  // namespace

std::vector<GraphLevel> coarsen_graph(WeightedGraph graph, std::size_t movable,
                                      std::size_t wanted) {
  TF_CHECK(movable <= graph.size());
  std::int64_t total = 0;
  for (std::size_t v = 0; v < movable; ++v) total += graph.weight[v];
  const std::int64_t heaviest =
      heaviest_over_wanted *
      (total / static_cast<std::int64_t>(std::max<std::size_t>(wanted, 1)) + 1);
  std::vector<GraphLevel> levels;
  levels.push_back({std::move(graph), movable, {}});
  while (levels.back().movable > wanted) {
    const GraphLevel& fine = levels.back();
    GraphLevel coarse;
    coarse.coarse_of = join_in_pairs(fine, heaviest, coarse.movable);
    if (static_cast<double>(coarse.movable) > hardly_coarser * static_cast<double>(fine.movable)) {
      break;
    }
    coarse.graph = contracted(fine.graph, coarse.coarse_of);
    levels.push_back(std::move(coarse));
  }
  return levels;
}

}  // namespace tetfarm
