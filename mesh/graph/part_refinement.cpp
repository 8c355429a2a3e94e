#include "mesh/graph/part_refinement.h"

#include <algorithm>
#include <map>

#include "base/array_index.h"
#include "base/check.h"

namespace tetfarm {
namespace {

/// A neighbouring part, and the edges to it.
struct Bond {
  std::int32_t part = 0;
  std::int64_t edges = 0;
};

class Refiner {
 public:
  Refiner(const WeightedGraph& graph, const PartRefinement& options,
          std::vector<std::int32_t>& part_of_node, std::vector<std::int64_t>& weights)
      : graph_(graph),
        heaviest_(options.heaviest),
        part_(part_of_node),
        weights_(weights),
        visit_(graph.size(), 0) {}

  /// The number of nodes that moved. Nodes of parts that are too heavy may lose `price` edges.
  std::size_t pass(std::size_t movable, std::int64_t price) {
    std::size_t moved = 0;
    for (std::size_t v = 0; v < movable; ++v) {
      if (is_inside(v)) continue;
      const std::int32_t to = best_part(v, price);
      if (to == part_[v] || !stays_whole_without(v)) continue;
      weights_[at(part_[v])] -= graph_.weight[v];
      weights_[at(to)] += graph_.weight[v];
      TF_CHECK(weights_[at(part_[v])] > 0);  // none becomes empty
      part_[v] = to;
      ++moved;
    }
    return moved;
  }

 private:
  bool is_inside(std::size_t v) const {
    for (std::size_t e = graph_.begin(v); e < graph_.end(v); ++e) {
      if (part_[at(graph_.neighbour[e])] != part_[v]) return false;
    }
    return true;
  }

  void find_bonds(std::size_t v) {
    bonds_.clear();
    for (std::size_t e = graph_.begin(v); e < graph_.end(v); ++e) {
      const std::int32_t part = part_[at(graph_.neighbour[e])];
      const auto known = std::find_if(bonds_.begin(), bonds_.end(),
                                      [&](const Bond& bond) { return bond.part == part; });
      if (known != bonds_.end()) {
        known->edges += graph_.edge_weight[e];
      } else {
        bonds_.push_back({part, graph_.edge_weight[e]});
      }
    }
  }

  /// The part that v should go to, or its own.
  std::int32_t best_part(std::size_t v, std::int64_t price) {
    find_bonds(v);
    const std::int32_t from = part_[v];
    const std::int64_t weight = graph_.weight[v];
    const std::int64_t left = weights_[at(from)] - weight;
    if (left <= 0) return from;
    std::int64_t own = 0;
    for (const Bond& bond : bonds_) {
      if (bond.part == from) own = bond.edges;
    }
    const bool is_too_heavy = weights_[at(from)] > heaviest_;
    Bond best{from, own};
    for (const Bond& bond : bonds_) {
      const std::int64_t after = weights_[at(bond.part)] + weight;
      if (bond.part == from || (after > heaviest_ && !(is_too_heavy && after <= left))) continue;
      const bool evens_out = after <= left;
      const bool is_worth_it = bond.edges > own || (bond.edges == own && evens_out) ||
                               (is_too_heavy && evens_out && bond.edges + price >= own);
      if (is_worth_it && (best.part == from || is_better(bond, best))) best = bond;
    }
    return best.part;
  }

  bool is_better(const Bond& a, const Bond& b) const {
    if (a.edges != b.edges) return a.edges > b.edges;
    const std::int64_t weight_a = weights_[at(a.part)];
    const std::int64_t weight_b = weights_[at(b.part)];
    return weight_a != weight_b ? weight_a < weight_b : a.part < b.part;
  }

  /// Whether the neighbours of v in its part still hang together without it, as far as a short
  /// search can tell.
  bool stays_whole_without(std::size_t v) {
    constexpr std::size_t longest_search = 96;
    ++stamp_;
    visit_[v] = stamp_;
    std::size_t wanted = 0;
    open_.clear();
    targets_.clear();
    for (std::size_t e = graph_.begin(v); e < graph_.end(v); ++e) {
      const std::int32_t w = graph_.neighbour[e];
      if (part_[at(w)] == part_[v]) targets_.push_back(w);
    }
    if (targets_.size() < 2) return true;
    open_.push_back(targets_.front());
    visit_[at(targets_.front())] = stamp_;
    for (std::size_t next = 0; next < open_.size() && next < longest_search; ++next) {
      const std::int32_t here = open_[next];
      wanted += std::count(targets_.begin(), targets_.end(), here) > 0 ? 1U : 0U;
      if (wanted == targets_.size()) return true;
      for (std::size_t e = graph_.begin(at(here)); e < graph_.end(at(here)); ++e) {
        const std::int32_t w = graph_.neighbour[e];
        if (part_[at(w)] != part_[v] || visit_[at(w)] == stamp_) continue;
        visit_[at(w)] = stamp_;
        open_.push_back(w);
      }
    }
    return false;
  }

  const WeightedGraph& graph_;
  std::int64_t heaviest_;
  std::vector<std::int32_t>& part_;
  std::vector<std::int64_t>& weights_;
  std::vector<Bond> bonds_;
  std::vector<std::int32_t> open_;
  std::vector<std::int32_t> targets_;
  std::vector<std::uint32_t> visit_;
  std::uint32_t stamp_ = 0;
};

/// Pieces that are not where their part is.
struct Strays {
  std::vector<std::vector<std::int32_t>> nodes_of_piece;
  std::vector<bool> is_stray;
};

Strays find_strays(const WeightedGraph& graph, std::int32_t parts,
                   const std::vector<std::int32_t>& part_of_node) {
  const std::vector<std::int32_t> piece_of_node = pieces_of_parts(graph, part_of_node);
  Strays strays;
  std::vector<std::int64_t> weights;
  for (std::size_t v = 0; v < graph.size(); ++v) {
    const std::size_t piece = at(piece_of_node[v]);
    if (piece == weights.size()) {
      weights.push_back(0);
      strays.nodes_of_piece.emplace_back();
    }
    weights[piece] += graph.weight[v];
    strays.nodes_of_piece[piece].push_back(static_cast<std::int32_t>(v));
  }
  constexpr std::size_t none = static_cast<std::size_t>(-1);
  std::vector<std::size_t> heaviest(at(parts), none);
  for (std::size_t piece = 0; piece < weights.size(); ++piece) {
    std::size_t& best = heaviest[at(part_of_node[at(strays.nodes_of_piece[piece].front())])];
    if (best == none || weights[piece] > weights[best]) best = piece;
  }
  strays.is_stray.assign(weights.size(), true);
  for (const std::size_t piece : heaviest) {
    if (piece != none) strays.is_stray[piece] = false;
  }
  return strays;
}

}  // namespace

void join_pieces(const WeightedGraph& graph, std::int32_t parts,
                 std::vector<std::int32_t>& part_of_node) {
  TF_CHECK(parts > 0 && part_of_node.size() == graph.size());
  Strays strays = find_strays(graph, parts, part_of_node);
  std::vector<bool> is_settled(graph.size(), true);
  for (std::size_t piece = 0; piece < strays.is_stray.size(); ++piece) {
    if (!strays.is_stray[piece]) continue;
    for (const std::int32_t v : strays.nodes_of_piece[piece]) is_settled[at(v)] = false;
  }
  bool has_changed = true;
  while (has_changed) {
    has_changed = false;
    for (std::size_t piece = 0; piece < strays.is_stray.size(); ++piece) {
      if (!strays.is_stray[piece]) continue;
      std::map<std::int32_t, std::int64_t> bonds;
      for (const std::int32_t v : strays.nodes_of_piece[piece]) {
        for (std::size_t e = graph.begin(at(v)); e < graph.end(at(v)); ++e) {
          const std::size_t w = at(graph.neighbour[e]);
          if (is_settled[w]) bonds[part_of_node[w]] += graph.edge_weight[e];
        }
      }
      if (bonds.empty()) continue;
      const auto best =
          std::max_element(bonds.begin(), bonds.end(),
                           [](const auto& a, const auto& b) { return a.second < b.second; });
      for (const std::int32_t v : strays.nodes_of_piece[piece]) {
        part_of_node[at(v)] = best->first;
        is_settled[at(v)] = true;
      }
      strays.is_stray[piece] = false;
      has_changed = true;
    }
  }
}

void refine_parts(const WeightedGraph& graph, std::size_t movable, const PartRefinement& options,
                  std::vector<std::int32_t>& part_of_node, std::vector<std::int64_t>& weights) {
  TF_CHECK(movable <= graph.size() && part_of_node.size() == graph.size());
  Refiner refiner(graph, options, part_of_node, weights);
  std::int64_t price = 0;
  for (int pass = 0; pass < options.passes; ++pass) {
    const bool is_even = *std::max_element(weights.begin(), weights.end()) <= options.heaviest;
    if (refiner.pass(movable, price) == 0 && is_even) return;
    price = price == 0 ? 1 : 2 * price;
  }
}

}  // namespace tetfarm
