#include "mesh/cosmetics/element_extraction.h"

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

#include "base/check.h"
#include "base/error.h"
#include "mesh/core/tet_layers.h"
#include "mesh/cosmetics/element_passing.h"
#include "mesh/cosmetics/height_raising.h"
#include "mesh/cosmetics/quality.h"

namespace tetfarm {
namespace {

std::size_t at(std::int64_t i) { return static_cast<std::size_t>(i); }

/// Place of a set in order of preference; more sharers come first.
using Rank = std::uint32_t;
constexpr Rank no_rank = std::numeric_limits<Rank>::max();

/// The sets by preference: the places in `sets`.
std::vector<std::uint32_t> by_preference(const std::vector<Sharers>& sets) {
  std::vector<std::uint32_t> order(sets.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(), [&sets](std::uint32_t a, std::uint32_t b) {
    const Sharers& s = sets[a];
    const Sharers& t = sets[b];
    return s.size() != t.size() ? s.size() > t.size() : s < t;
  });
  return order;
}

/// The rank of each node of the mesh that is shared; no_rank for the others.
std::vector<Rank> ranks_of_nodes(const Subdomain& leaf, std::size_t nodes,
                                 const SharedNodes& shared,
                                 const std::vector<std::uint32_t>& preference) {
  std::vector<Rank> rank_of_set(preference.size());
  for (Rank rank = 0; rank < preference.size(); ++rank) rank_of_set[preference[rank]] = rank;
  std::vector<Rank> ranks(nodes, no_rank);
  for (std::size_t v = 0; v < leaf.vertices.size(); ++v) {
    const Origin& origin = leaf.node_origin[v];
    const auto found = std::lower_bound(
        shared.nodes.begin(), shared.nodes.end(), origin,
        [](const SharedNodes::Node& node, const Origin& wanted) { return node.origin < wanted; });
    if (found == shared.nodes.end() || found->origin != origin) continue;
    ranks[v] = rank_of_set[found->set];
  }
  return ranks;
}

/// A flag for the shared nodes that may gain from a move, from the tets at them. Those round which
/// the leaf has nothing but tets of the even lattice do not: no other place would make one of these
/// better. Such are most nodes of a cut along the lattice.
std::vector<bool> nodes_that_may_gain(const TetMesh& mesh, const std::vector<Rank>& of_node,
                                      const std::vector<std::uint32_t>& tets_at_cuts) {
  constexpr double least_dihedral_deg = 59.9;  // the lattice's tets have 60 and 90
  const double perfect = cosmetics::goodness_of_angle(least_dihedral_deg);
  std::vector<bool> may_gain(of_node.size(), false);
  for (const std::uint32_t t : tets_at_cuts) {
    const Tet& tet = mesh.tets[t];
    const auto point = [&](std::size_t i) -> const Vec3& { return mesh.nodes[at(tet[i])]; };
    if (cosmetics::goodness(point(0), point(1), point(2), point(3)) >= perfect) continue;
    for (const std::int32_t v : tet) may_gain[at(v)] = of_node[at(v)] != no_rank;
  }
  return may_gain;
}

/// Finds the set of sharers for tets whose nodes have different ones.
class SetChoice {
 public:
  SetChoice(const std::vector<Sharers>& sets, const std::vector<std::uint32_t>& preference)
      : sets_(sets), preference_(preference) {}

  /// The smallest set that holds all sharers of the four nodes, so that each of them has at hand
  /// what its own nodes need; the preferred one of theirs where there is none.
  Rank of(std::array<Rank, 4> ranks) {
    const Rank first = *std::min_element(ranks.begin(), ranks.end());
    if (std::ranges::all_of(ranks, [first](Rank r) { return r == first || r == no_rank; })) {
      return first;
    }
    std::sort(ranks.begin(), ranks.end());
    const auto last = std::unique(ranks.begin(), std::find(ranks.begin(), ranks.end(), no_rank));
    std::fill(last, ranks.end(), no_rank);
    const auto [place, is_new] = known_.try_emplace(ranks, ranks[0]);
    if (is_new) place->second = smallest_round(ranks);
    return place->second;
  }

 private:
  const Sharers& sharers(Rank rank) const { return sets_[preference_[rank]]; }

  Rank smallest_round(const std::array<Rank, 4>& ranks) const {
    Rank best = no_rank;
    for (Rank rank = 0; rank < preference_.size(); ++rank) {
      const Sharers& set = sharers(rank);
      if (best != no_rank && set.size() >= sharers(best).size()) continue;
      const bool holds_all = std::all_of(ranks.begin(), ranks.end(), [&](Rank r) {
        return r == no_rank || std::ranges::includes(set, sharers(r));
      });
      if (holds_all) best = rank;
    }
    return best == no_rank ? ranks[0] : best;
  }

  const std::vector<Sharers>& sets_;
  const std::vector<std::uint32_t>& preference_;
  std::map<std::array<Rank, 4>, Rank> known_;
};

/// A tet near a cut.
struct NearTet {
  std::uint32_t tet = 0;
  Rank rank = no_rank;
  bool is_taken = false;
};

/// Finds the tets within reach of a shared node, layer by layer, and their ranks.
class NearTets {
 public:
  NearTets(const TetMesh& mesh, std::vector<Rank> of_node, SetChoice sets)
      : mesh_(mesh),
        of_node_(std::move(of_node)),
        sets_(std::move(sets)),
        layers_(mesh.tets, of_node_.size()) {
    for (std::size_t v = 0; v < of_node_.size(); ++v) {
      if (of_node_[v] != no_rank) layers_.reach(static_cast<std::int32_t>(v));
    }
  }

  /// The next layer; one that is always taken is taken at nodes that may gain.
  void add_layer(bool is_always_taken) {
    const std::vector<std::uint32_t> tets = layers_.next();
    if (near_.empty()) may_gain_ = nodes_that_may_gain(mesh_, of_node_, tets);
    const std::size_t first = near_.size();
    for (const std::uint32_t t : tets) {
      near_.push_back({t, rank_of(mesh_.tets[t]), is_always_taken && may_gain(mesh_.tets[t])});
    }
    reach_nodes_from(first);
  }

  /// Layer by layer.
  std::vector<NearTet>& tets() { return near_; }

 private:
  Rank rank_of(const Tet& tet) {
    return sets_.of(
        {of_node_[at(tet[0])], of_node_[at(tet[1])], of_node_[at(tet[2])], of_node_[at(tet[3])]});
  }

  bool may_gain(const Tet& tet) const {
    return std::any_of(tet.begin(), tet.end(), [&](auto v) { return may_gain_[at(v)]; });
  }

  /// Of the tets from the `first` on: their nodes, at which no tet has been, have the least rank of
  /// these.
  void reach_nodes_from(std::size_t first) {
    std::vector<std::pair<std::int32_t, Rank>> reached;
    for (std::size_t i = first; i < near_.size(); ++i) {
      for (const std::int32_t v : mesh_.tets[near_[i].tet]) {
        if (near_[i].is_taken) may_gain_[at(v)] = true;
        if (of_node_[at(v)] == no_rank) reached.emplace_back(v, near_[i].rank);
      }
    }
    for (const auto& [v, rank] : reached) {
      of_node_[at(v)] = std::min(of_node_[at(v)], rank);
      layers_.reach(v);
    }
  }

  const TetMesh& mesh_;
  std::vector<Rank> of_node_;
  SetChoice sets_;
  TetLayers layers_;
  std::vector<bool> may_gain_;
  std::vector<NearTet> near_;
};

/// What cosmetics would leave as it is.
struct GoodEnough {
  double goodness = 0;
  double height2_in_edges = 0;

  explicit GoodEnough(const ExtractionOptions& options)
      : goodness(cosmetics::goodness_of_angle(options.wanted_dihedral_deg)),
        height2_in_edges(options.height_in_edges * options.height_in_edges) {}

  bool operator()(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) const {
    if (cosmetics::goodness(a, b, c, d) < goodness) return false;
    const double longest2 = std::max(
        std::max(std::max(norm2(b - a), norm2(c - a)), std::max(norm2(d - a), norm2(c - b))),
        std::max(norm2(d - b), norm2(d - c)));
    return cosmetics::smallest_height2(a, b, c, d) >= height2_in_edges * longest2;
  }
};

/// The nodes of those tets that are bad.
std::vector<std::int32_t> nodes_of_bad(const TetMesh& mesh, const std::vector<NearTet>& near,
                                       const ExtractionOptions& options) {
  const GoodEnough is_good(options);
  std::vector<std::int32_t> nodes;
  for (const NearTet& item : near) {
    const Tet& tet = mesh.tets[item.tet];
    const auto point = [&](std::size_t i) -> const Vec3& { return mesh.nodes[at(tet[i])]; };
    if (!is_good(point(0), point(1), point(2), point(3))) {
      nodes.insert(nodes.end(), tet.begin(), tet.end());
    }
  }
  return nodes;
}

/// Takes so many layers round the nodes, of the tets that are near.
void take_round(std::vector<std::int32_t> nodes, const TetMesh& mesh, int layers,
                std::vector<NearTet>& near) {
  std::vector<bool> is_reached(mesh.nodes.size(), false);
  for (int layer = 0; layer < layers; ++layer) {
    for (const std::int32_t v : nodes) is_reached[at(v)] = true;
    nodes.clear();
    for (NearTet& item : near) {
      const Tet& tet = mesh.tets[item.tet];
      if (std::none_of(tet.begin(), tet.end(), [&](auto v) { return is_reached[at(v)]; })) continue;
      item.is_taken = true;
      nodes.insert(nodes.end(), tet.begin(), tet.end());
    }
  }
}

/// The tets that are taken, ascending.
std::vector<NearTet> taken_tets(const TetMesh& mesh, NearTets near,
                                const ExtractionOptions& options) {
  for (int layer = 0; layer < options.sought_layers; ++layer) {
    near.add_layer(layer < options.taken_layers);
  }
  std::vector<std::int32_t> bad = nodes_of_bad(mesh, near.tets(), options);
  if (!bad.empty()) {
    for (int layer = 0; layer < options.layers_round_bad; ++layer) near.add_layer(false);
    take_round(std::move(bad), mesh, options.layers_round_bad, near.tets());
  }
  std::vector<NearTet> taken = std::move(near.tets());
  std::erase_if(taken, [](const NearTet& item) { return !item.is_taken; });
  std::sort(taken.begin(), taken.end(),
            [](const NearTet& a, const NearTet& b) { return a.tet < b.tet; });
  return taken;
}

Origin origin_of(const Subdomain& leaf, std::size_t node) {
  const std::size_t outer = leaf.vertices.size();
  if (node < outer) return leaf.node_origin[node];
  return {leaf.path.heap, static_cast<std::uint32_t>(node - outer)};
}

/// Gives the section those nodes of the mesh, ascending by origin, and its elements the numbers
/// there.
void take_nodes_by_origin(const Subdomain& leaf, const TetMesh& mesh,
                          const std::vector<bool>& is_used, ElementSection& section) {
  std::vector<std::int32_t> order;
  for (std::size_t v = 0; v < mesh.nodes.size(); ++v) {
    if (is_used[v]) order.push_back(static_cast<std::int32_t>(v));
  }
  const auto by_origin = [&leaf](std::int32_t a, std::int32_t b) {
    return origin_of(leaf, at(a)) < origin_of(leaf, at(b));
  };
  if (!std::is_sorted(order.begin(), order.end(), by_origin)) {
    std::sort(order.begin(), order.end(), by_origin);
  }
  std::vector<std::int32_t> number(mesh.nodes.size(), -1);
  for (const std::int32_t v : order) {
    number[at(v)] = static_cast<std::int32_t>(section.nodes.size());
    section.nodes.push_back(mesh.nodes[at(v)]);
    section.node_origin.push_back(origin_of(leaf, at(v)));
  }
  for (Tet& tet : section.tets) {
    for (std::int32_t& v : tet) v = number[at(v)];
  }
  for (Triangle& triangle : section.triangles) {
    for (std::int32_t& v : triangle) v = number[at(v)];
  }
}

/// The taken tets as a mesh of their own, its nodes ascending by origin.
JoinedElements taken_elements(const Subdomain& leaf, const TetMesh& mesh,
                              const std::vector<NearTet>& near,
                              const std::vector<ElementHome>& home_of_rank) {
  JoinedElements joined;
  std::vector<std::int32_t> number(mesh.nodes.size(), -1);
  std::vector<std::pair<Origin, std::int32_t>> nodes;
  for (const NearTet& item : near) {
    joined.tets.push_back(mesh.tets[item.tet]);
    joined.tet_home.push_back(home_of_rank[item.rank]);
    for (const std::int32_t v : mesh.tets[item.tet]) {
      if (number[at(v)] >= 0) continue;
      number[at(v)] = 0;
      nodes.emplace_back(origin_of(leaf, at(v)), v);
    }
  }
  std::sort(nodes.begin(), nodes.end());
  for (const auto& [origin, v] : nodes) {
    number[at(v)] = static_cast<std::int32_t>(joined.nodes.size());
    joined.nodes.push_back(mesh.nodes[at(v)]);
    joined.node_origin.push_back(origin);
  }
  for (Tet& tet : joined.tets) {
    for (std::int32_t& v : tet) v = number[at(v)];
  }
  for (std::size_t t = 0; t < leaf.triangles.size(); ++t) {
    if (leaf.triangle_origin[t].owner != 0) continue;
    Triangle triangle = leaf.triangles[t];
    for (std::int32_t& v : triangle) v = number[at(v)];
    if (*std::min_element(triangle.begin(), triangle.end()) < 0) continue;
    joined.triangles.push_back(triangle);
    joined.triangle_index.push_back(leaf.triangle_origin[t].index);
  }
  return joined;
}

/// Leaves out the triangles that are a face of none of the tets.
void keep_faces_only(JoinedElements& joined) {
  const auto tet_of = tets_of_triangles(joined.nodes.size(), joined.tets, joined.triangles);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < tet_of.size(); ++i) {
    if (tet_of[i] == joined.tets.size()) continue;
    joined.triangles[kept] = joined.triangles[i];
    joined.triangle_index[kept++] = joined.triangle_index[i];
  }
  joined.triangles.resize(kept);
  joined.triangle_index.resize(kept);
}

}  // namespace

ExtractedElements extract_elements(const Subdomain& leaf, const TetMesh& mesh,
                                   const SharedNodes& shared, const ExtractionOptions& options) {
  TF_CHECK(shared.path == leaf.path);
  const std::vector<std::uint32_t> preference = by_preference(shared.sets);
  std::vector<Rank> ranks = ranks_of_nodes(leaf, mesh.nodes.size(), shared, preference);
  const std::vector<NearTet> near = taken_tets(
      mesh, NearTets(mesh, std::move(ranks), SetChoice(shared.sets, preference)), options);
  std::vector<bool> has_tets(shared.sets.size(), false);
  for (const NearTet& item : near) has_tets[preference[item.rank]] = true;
  std::vector<Sharers> sharers;
  for (std::size_t set = 0; set < shared.sets.size(); ++set) {
    if (has_tets[set]) sharers.push_back(shared.sets[set]);
  }
  std::sort(sharers.begin(), sharers.end());
  std::vector<ElementHome> home_of_rank;
  for (const std::uint32_t set : preference) {
    const Sharers& wanted = shared.sets[set];
    const auto section = std::lower_bound(sharers.begin(), sharers.end(), wanted);
    const auto owner = std::lower_bound(wanted.begin(), wanted.end(), leaf.path.heap);
    home_of_rank.push_back({static_cast<std::uint32_t>(section - sharers.begin()),
                            static_cast<std::uint8_t>(owner - wanted.begin())});
  }
  JoinedElements joined = taken_elements(leaf, mesh, near, home_of_rank);
  keep_faces_only(joined);
  ExtractedElements extracted;
  extracted.sections = share_out_elements(joined, sharers);
  CoreElements& core = extracted.core;
  core.tets = mesh.tets.size() - near.size();
  for (const NearTet& item : near) core.taken_tets.push_back(item.tet);
  core.taken_triangles = std::move(joined.triangle_index);
  std::sort(core.taken_triangles.begin(), core.taken_triangles.end());
  const auto of_surface = std::count_if(leaf.triangle_origin.begin(), leaf.triangle_origin.end(),
                                        [](const Origin& origin) { return origin.owner == 0; });
  core.triangles = static_cast<std::uint64_t>(of_surface) - core.taken_triangles.size();
  return extracted;
}

ElementSection core_section(const Subdomain& leaf, const TetMesh& mesh, const CoreElements& core) {
  const auto& taken = core.taken_tets;
  if (core.tets + taken.size() != mesh.tets.size() ||
      (!taken.empty() && taken.back() >= mesh.tets.size())) {
    throw Error(ExitCode::failed, "what was taken out of a core is not of its mesh");
  }
  ElementSection section;
  section.sharers = {leaf.path.heap};
  std::vector<bool> is_used(mesh.nodes.size(), false);
  auto next = taken.begin();
  section.tets.reserve(core.tets);
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    if (next != taken.end() && *next == t) {
      ++next;
      continue;
    }
    section.tets.push_back(mesh.tets[t]);
    for (const std::int32_t v : mesh.tets[t]) is_used[at(v)] = true;
  }
  section.tet_owner.assign(section.tets.size(), 0);
  const auto& triangles = core.taken_triangles;
  for (std::size_t t = 0; t < leaf.triangles.size(); ++t) {
    const Origin& origin = leaf.triangle_origin[t];
    if (origin.owner != 0) continue;
    if (std::binary_search(triangles.begin(), triangles.end(), origin.index)) continue;
    section.triangles.push_back(leaf.triangles[t]);
    section.triangle_index.push_back(origin.index);
  }
  section.triangle_owner.assign(section.triangles.size(), 0);
  take_nodes_by_origin(leaf, mesh, is_used, section);
  return section;
}

}  // namespace tetfarm
