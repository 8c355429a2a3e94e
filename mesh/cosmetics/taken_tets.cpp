#include "mesh/cosmetics/taken_tets.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "base/array_index.h"
#include "base/check.h"
#include "mesh/core/tet_layers.h"
#include "mesh/cosmetics/altitude_improvement.h"
#include "mesh/cosmetics/quality.h"

namespace tetfarm {
namespace {

constexpr SetRank no_rank = no_set_rank;

/// A flag for the shared nodes that may gain from a move, from the tets at them. Those round which
/// the leaf has nothing but tets of the even lattice do not: no other place would make one of these
/// better. Such are most nodes of a cut along the lattice.
std::vector<bool> nodes_that_may_gain(const TetMesh& mesh, const std::vector<SetRank>& of_node,
                                      const std::vector<std::uint32_t>& tets_at_cuts) {
  constexpr double least_dihedral_deg = 59.9;  // the lattice's tets have 60 and 90
  const double perfect = cosmetics::quality_of_angle(least_dihedral_deg);
  std::vector<bool> may_gain(of_node.size(), false);
  for (const std::uint32_t t : tets_at_cuts) {
    const Tet& tet = mesh.tets[t];
    const auto point = [&](std::size_t i) -> const Vec3& { return mesh.nodes[at(tet[i])]; };
    if (cosmetics::quality(point(0), point(1), point(2), point(3)) >= perfect) continue;
    for (const std::int32_t v : tet) may_gain[at(v)] = of_node[at(v)] != no_rank;
  }
  return may_gain;
}

/// Finds the set of sharers for tets whose nodes have different ones.
class SetChoice {
 public:
  explicit SetChoice(const std::vector<Sharers>& preferred) : preferred_(preferred) {}

  /// The smallest set that holds all sharers of the four nodes, so that each of them has at hand
  /// what its own nodes need; the preferred one of theirs where there is none.
  SetRank of(std::array<SetRank, 4> ranks) {
    const SetRank first = *std::min_element(ranks.begin(), ranks.end());
    if (std::ranges::all_of(ranks, [first](SetRank r) { return r == first || r == no_rank; })) {
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
  SetRank smallest_round(const std::array<SetRank, 4>& ranks) const {
    SetRank best = no_rank;
    for (SetRank rank = 0; rank < preferred_.size(); ++rank) {
      const Sharers& set = preferred_[rank];
      if (best != no_rank && set.size() >= preferred_[best].size()) continue;
      const bool holds_all = std::all_of(ranks.begin(), ranks.end(), [&](SetRank r) {
        return r == no_rank || std::ranges::includes(set, preferred_[r]);
      });
      if (holds_all) best = rank;
    }
    return best == no_rank ? ranks[0] : best;
  }

  const std::vector<Sharers>& preferred_;
  std::map<std::array<SetRank, 4>, SetRank> known_;
};

/// What cosmetics would leave as it is.
struct GoodEnough {
  double quality = 0;
  double height2_in_edges = 0;

  explicit GoodEnough(const ExtractionOptions& options)
      : quality(cosmetics::quality_of_angle(options.wanted_dihedral_deg)),
        height2_in_edges(options.height_in_edges * options.height_in_edges) {}

  bool operator()(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) const {
    const std::array<double, 6> edges2 = {norm2(b - a), norm2(c - a), norm2(d - a),
                                          norm2(c - b), norm2(d - b), norm2(d - c)};
    const auto [shortest2, longest2] = std::minmax_element(edges2.begin(), edges2.end());
    if (is_clearly_good(tet_volume(a, b, c, d), *shortest2, *longest2)) return true;
    return cosmetics::quality(a, b, c, d) >= quality &&
           cosmetics::smallest_height2(a, b, c, d) >= height2_in_edges * *longest2;
  }

 private:
  /// By bounds that the tets of the lattice meet. No face is larger than √3/4 L² with the longest
  /// edge L, so that no height is below 4√3 V/L², and no sine of a dihedral angle,
  /// 3/2 V l / (A₁ A₂), below 8 V l / L⁴ with the shortest edge l.
  bool is_clearly_good(double volume, double shortest2, double longest2) const {
    constexpr double margin = 1.001;
    const double longest6 = longest2 * longest2 * longest2;
    return volume > 0 &&
           64 * volume * volume * shortest2 >= margin * quality * longest6 * longest2 &&
           48 * volume * volume >= margin * height2_in_edges * longest6;
  }
};

/// A tet near a cut.
struct NearTet {
  TakenTet of;
  bool is_taken = false;
};

/// Finds the tets within reach of a shared node, layer by layer, and their ranks.
class NearTets {
 public:
  NearTets(const TetMesh& mesh, std::vector<SetRank> of_node, const std::vector<Sharers>& preferred)
      : mesh_(mesh),
        of_node_(std::move(of_node)),
        least_round_(of_node_.size(), no_rank),
        sets_(preferred),
        blocks_(mesh.tets, of_node_.size()),
        layers_(blocks_) {
    TF_CHECK(of_node_.size() == mesh.nodes.size());
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
      near_.push_back({{t, rank_of(mesh_.tets[t])}, is_always_taken && may_gain(mesh_.tets[t])});
    }
    reach_nodes_from(first);
  }

  /// The nodes of those that are bad.
  std::vector<std::int32_t> nodes_of_bad(const ExtractionOptions& options) const {
    const GoodEnough is_good(options);
    std::vector<std::int32_t> nodes;
    for (const NearTet& item : near_) {
      const Tet& tet = mesh_.tets[item.of.tet];
      const auto point = [&](std::size_t i) -> const Vec3& { return mesh_.nodes[at(tet[i])]; };
      if (!is_good(point(0), point(1), point(2), point(3))) {
        nodes.insert(nodes.end(), tet.begin(), tet.end());
      }
    }
    return nodes;
  }

  /// Takes so many layers round the nodes, also behind the layers so far. The rank there comes from
  /// tets on the way that need not be taken: they lie in the further rings that are looked at.
  void take_round(const std::vector<std::int32_t>& nodes, int layers) {
    if (layers == 0 || nodes.empty()) return;
    const std::vector<Ring> rings = rings_round(nodes, 2 * layers - 1);
    std::vector<bool> is_taken(mesh_.tets.size(), false);
    for (int ring = 0; ring < layers; ++ring) {
      for (const std::uint32_t t : rings[at(ring)]) is_taken[t] = true;
    }
    for (NearTet& item : near_) item.is_taken = item.is_taken || is_taken[item.of.tet];
    Ring beyond;
    for (const Ring& ring : rings) {
      std::copy_if(ring.begin(), ring.end(), std::back_inserter(beyond),
                   [this](std::uint32_t t) { return !layers_.has(t); });
    }
    for (int layer = 0; layer < layers; ++layer) add_layer_of(beyond, is_taken);
  }

  /// Ascending.
  std::vector<TakenTet> taken() const {
    std::vector<TakenTet> taken;
    for (const NearTet& item : near_) {
      if (item.is_taken) taken.push_back(item.of);
    }
    std::sort(taken.begin(), taken.end(),
              [](const TakenTet& a, const TakenTet& b) { return a.tet < b.tet; });
    return taken;
  }

 private:
  using Ring = std::vector<std::uint32_t>;

  SetRank rank_of(const Tet& tet) {
    return sets_.of(
        {of_node_[at(tet[0])], of_node_[at(tet[1])], of_node_[at(tet[2])], of_node_[at(tet[3])]});
  }

  bool may_gain(const Tet& tet) const {
    return std::any_of(tet.begin(), tet.end(), [&](auto v) { return may_gain_[at(v)]; });
  }

  /// Of the tets from the `first` on: their nodes, at which no tet has been, have the least rank of
  /// these.
  void reach_nodes_from(std::size_t first) {
    std::vector<std::int32_t> reached;
    for (std::size_t i = first; i < near_.size(); ++i) {
      for (const std::int32_t v : mesh_.tets[near_[i].of.tet]) {
        if (near_[i].is_taken) may_gain_[at(v)] = true;
        if (of_node_[at(v)] != no_rank) continue;
        SetRank& least = least_round_[at(v)];
        if (least == no_rank) reached.push_back(v);
        least = std::min(least, near_[i].of.rank);
      }
    }
    for (const std::int32_t v : reached) {
      of_node_[at(v)] = least_round_[at(v)];
      layers_.reach(v);
    }
  }

  std::vector<Ring> rings_round(const std::vector<std::int32_t>& nodes, int count) const {
    TetLayers round(blocks_);
    for (const std::int32_t v : nodes) round.reach(v);
    std::vector<Ring> rings;
    for (int ring = 0; ring < count; ++ring) {
      rings.push_back(round.next());
      round.reach_nodes_of(rings.back());
    }
    return rings;
  }

  /// Of those tets alone, the ones at nodes that were reached; they leave `tets`.
  void add_layer_of(Ring& tets, const std::vector<bool>& is_taken) {
    const std::size_t first = near_.size();
    std::erase_if(tets, [&](std::uint32_t t) {
      const SetRank rank = rank_of(mesh_.tets[t]);
      if (rank == no_rank) return false;
      near_.push_back({{t, rank}, is_taken[t]});
      return true;
    });
    reach_nodes_from(first);
  }

  const TetMesh& mesh_;
  std::vector<SetRank> of_node_;
  std::vector<SetRank> least_round_;  ///< of nodes, of the tets of the layer being added
  SetChoice sets_;
  TetBlocks blocks_;
  TetLayers layers_;
  std::vector<bool> may_gain_;
  std::vector<NearTet> near_;
};

}  // namespace

std::vector<TakenTet> taken_tets(const TetMesh& mesh, std::vector<SetRank> rank_of_node,
                                 const std::vector<Sharers>& preferred,
                                 const ExtractionOptions& options) {
  NearTets near(mesh, std::move(rank_of_node), preferred);
  for (int layer = 0; layer < options.sought_layers; ++layer) {
    near.add_layer(layer < options.taken_layers);
  }
  near.take_round(near.nodes_of_bad(options), options.layers_round_bad);
  return near.taken();
}

}  // namespace tetfarm
