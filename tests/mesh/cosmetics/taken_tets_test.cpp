#include "mesh/cosmetics/taken_tets.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "base/array_index.h"
#include "mesh/cosmetics/quality.h"
#include "tests/mesh/cosmetics/trial_meshes.h"

namespace tetfarm {
namespace {

using testing::IsEmpty;

const std::vector<Sharers> two_sets = {{8, 9, 10}, {8, 9}};

/// Only angles count.
ExtractionOptions angles_only() {
  ExtractionOptions options;
  options.height_in_edges = 0;
  return options;
}

/// Nodes with x = 0 are shared: by all three leaves at y = 0, by two elsewhere.
std::vector<SetRank> ranks_at_side(const TetMesh& mesh) {
  std::vector<SetRank> ranks;
  for (const Vec3& p : mesh.nodes) ranks.push_back(p.x > 0 ? no_set_rank : p.y > 0 ? 1 : 0);
  return ranks;
}

std::int32_t node_at(const TetMesh& mesh, const Vec3& place) {
  const auto found = std::find(mesh.nodes.begin(), mesh.nodes.end(), place);
  return static_cast<std::int32_t>(found - mesh.nodes.begin());
}

/// Cubes of six tets, and the same turned over in y, in one: all nodes of a cube are neighbours,
/// which is as far as layers can go in each direction. Bad tets round the nodes that lay there.
TetMesh cubes_with_bad_tets_at(std::initializer_list<Vec3> places) {
  constexpr double edge = 12;
  TetMesh mesh = trial::kuhn_box(12);
  std::vector<std::int32_t> turned_over;
  for (const Vec3& p : mesh.nodes) turned_over.push_back(node_at(mesh, {p.x, edge - p.y, p.z}));
  const std::size_t count = mesh.tets.size();
  for (std::size_t t = 0; t < count; ++t) {
    const auto& [a, b, c, d] = mesh.tets[t];
    mesh.tets.push_back(
        {turned_over[at(a)], turned_over[at(c)], turned_over[at(b)], turned_over[at(d)]});
  }
  for (const Vec3& place : places) mesh.nodes[at(node_at(mesh, place))] += Vec3{-0.45, 0.3, 0.2};
  return mesh;
}

/// The same by looking at all tets for each layer, and taking layers behind those where bad tets
/// are sought as a whole.
class AllTets {
 public:
  explicit AllTets(const TetMesh& mesh)
      : mesh_(mesh), rank_of_node_(ranks_at_side(mesh)), layer_(mesh.tets.size(), 0) {
    rank_.resize(mesh.tets.size(), no_set_rank);
    for (int layer = 1; layer <= 6; ++layer) add_layer(layer);
  }

  std::vector<std::pair<std::uint32_t, SetRank>> taken() const {
    std::vector<bool> is_at_bad(mesh_.nodes.size(), false);
    std::vector<bool> is_taken(mesh_.tets.size(), false);
    for (std::size_t t = 0; t < layer_.size(); ++t) {
      if (layer_[t] == 1) is_taken[t] = true;
      if (layer_[t] >= 1 && layer_[t] <= 4 && is_bad(mesh_.tets[t])) mark(t, is_at_bad);
    }
    for (int round = 0; round < 2; ++round) {
      std::vector<bool> next = is_at_bad;
      for (std::size_t t = 0; t < layer_.size(); ++t) {
        const Tet& tet = mesh_.tets[t];
        if (std::none_of(tet.begin(), tet.end(), [&](auto v) { return is_at_bad[at(v)]; }))
          continue;
        is_taken[t] = true;
        mark(t, next);
      }
      is_at_bad = next;
    }
    std::vector<std::pair<std::uint32_t, SetRank>> taken;
    for (std::uint32_t t = 0; t < layer_.size(); ++t) {
      if (is_taken[t]) taken.emplace_back(t, rank_[t]);
    }
    return taken;
  }

 private:
  void add_layer(int layer) {
    std::vector<SetRank> next = rank_of_node_;
    for (std::size_t t = 0; t < layer_.size(); ++t) {
      if (layer_[t] > 0) continue;
      for (const std::int32_t v : mesh_.tets[t])
        rank_[t] = std::min(rank_[t], rank_of_node_[at(v)]);
      if (rank_[t] == no_set_rank) continue;
      layer_[t] = layer;
      for (const std::int32_t v : mesh_.tets[t]) {
        if (rank_of_node_[at(v)] == no_set_rank) next[at(v)] = std::min(next[at(v)], rank_[t]);
      }
    }
    rank_of_node_ = next;
  }
  void mark(std::size_t t, std::vector<bool>& nodes) const {
    for (const std::int32_t v : mesh_.tets[t]) nodes[at(v)] = true;
  }
  bool is_bad(const Tet& tet) const {
    const auto p = [&](std::size_t i) -> const Vec3& { return mesh_.nodes[at(tet[i])]; };
    return cosmetics::quality(p(0), p(1), p(2), p(3)) < cosmetics::quality_of_angle(30);
  }

  const TetMesh& mesh_;
  std::vector<SetRank> rank_of_node_;
  std::vector<int> layer_;  ///< of each tet, from 1
  std::vector<SetRank> rank_;
};

std::vector<std::pair<std::uint32_t, SetRank>> taken_of(const TetMesh& mesh) {
  std::vector<std::pair<std::uint32_t, SetRank>> taken;
  for (const TakenTet& item : taken_tets(mesh, ranks_at_side(mesh), two_sets, angles_only())) {
    taken.emplace_back(item.tet, item.rank);
  }
  return taken;
}

TEST(TakenTets, without_bad_ones_are_the_layer_at_the_cut) {
  const TetMesh mesh = cubes_with_bad_tets_at({});
  const auto taken = taken_of(mesh);
  EXPECT_EQ(taken, AllTets(mesh).taken());
  EXPECT_EQ(taken.size(), 12U * 12U * 12U);
}

TEST(TakenTets, round_bad_ones_are_as_if_all_layers_had_been_looked_at) {
  for (const double x : {1, 2, 3, 4, 5, 6}) {
    for (const double y : {1, 2, 4, 6, 7, 8, 9}) {
      const TetMesh mesh = cubes_with_bad_tets_at({{x, y, 3}, {x, 9, 8}});
      EXPECT_EQ(taken_of(mesh), AllTets(mesh).taken()) << "bad at " << x << ", " << y;
    }
  }
}

TEST(TakenTets, bad_ones_far_from_cuts_are_left_alone) {
  const TetMesh good = cubes_with_bad_tets_at({});
  const TetMesh bad = cubes_with_bad_tets_at({{9, 5, 5}});
  EXPECT_EQ(taken_of(bad), taken_of(good));
}

TEST(TakenTets, without_shared_nodes_there_are_none) {
  const TetMesh mesh = cubes_with_bad_tets_at({{2, 2, 2}});
  const std::vector<SetRank> none(mesh.nodes.size(), no_set_rank);
  EXPECT_THAT(taken_tets(mesh, none, two_sets, angles_only()), IsEmpty());
}

}  // namespace
}  // namespace tetfarm
