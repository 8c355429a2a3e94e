// Whether the feet and depths of nodes are as the marks of cells say.
#pragma once

#include <gmock/gmock.h>

#include <cstdint>
#include <map>
#include <set>
#include <span>

#include "mesh/assemble/part_cells.h"
#include "mesh/formats/mesh_source.h"

namespace tetfarm::test {

/// A finished mesh with layers, by the numbers that its nodes have in the whole of it.
class FeetOfMesh {
 public:
  struct OnLine {
    std::int64_t foot = no_foot;
    std::int32_t depth = no_foot;

    friend bool operator==(const OnLine&, const OnLine&) = default;
  };

  explicit FeetOfMesh(const MeshSource& mesh) : mesh_(mesh) {
    EXPECT_TRUE(mesh.has_feet());
    for (std::size_t i = 0; i < mesh.size(); ++i) add_nodes(mesh.part(i));
  }

  /// All that has to hold of every mesh.
  void expect_sound() {
    for (std::size_t i = 0; i < mesh_.size(); ++i) look_at_cells(mesh_.part(i));
    EXPECT_GT(prisms_ + other_cells_, 0);
    for (const auto& [node, on] : of_node_) {
      EXPECT_EQ(on.foot != no_foot, of_layers_.contains(node)) << node;
      EXPECT_EQ(on.depth != no_foot, of_layers_.contains(node)) << node;
      if (on.foot == no_foot) continue;
      EXPECT_EQ(of_node_.at(on.foot), (OnLine{on.foot, 0}));
      EXPECT_EQ(on.depth == 0, on.foot == node) << node;
    }
  }

  const OnLine& of_node(std::int64_t node) const { return of_node_.at(node); }
  int prisms() const { return prisms_; }

 private:
  /// Copies of a node say the same.
  void add_nodes(const NumberedPart& part) {
    ASSERT_EQ(part.feet.foot.size(), part.nodes.size());
    ASSERT_EQ(part.feet.depth.size(), part.nodes.size());
    for (std::size_t v = 0; v < part.nodes.size(); ++v) {
      const OnLine on = {part.feet.foot[v], part.feet.depth[v]};
      const auto [known, is_new] = of_node_.emplace(part.local2global[v], on);
      EXPECT_EQ(known->second, on) << "two copies of node " << part.local2global[v];
    }
  }

  void look_at_cells(const NumberedPart& part) {
    const auto mark_of = [&part](CellMark mark, std::int32_t cell) {
      const std::vector<std::int32_t>& marks = part.marks[mark];
      return marks.empty() ? 0 : marks.at(static_cast<std::size_t>(cell));
    };
    for_each_cell(
        part, [&](std::int32_t cell, ElementType type, std::span<const std::int32_t> nodes) {
          const std::int32_t layer = mark_of(CellMark::layer, cell);
          const std::int32_t depth = mark_of(CellMark::pml_depth, cell);
          if (layer + depth == 0) return;
          std::vector<OnLine> on;
          for (const std::int32_t v : nodes) {
            const std::int64_t node = part.local2global[static_cast<std::size_t>(v)];
            of_layers_.insert(node);
            on.push_back(of_node_.at(node));
            EXPECT_THAT(on.back().depth, testing::AnyOf(layer + depth - 1, layer + depth));
          }
          if (type != ElementType::prism) {
            ++other_cells_;
            return;
          }
          ++prisms_;
          // The first three are on the wall's side; absorbing layers are counted from the other.
          for (std::size_t k = 0; k < 3; ++k) {
            EXPECT_EQ(on[k].foot, on[k + 3].foot) << "a column";
            EXPECT_EQ(on[k].depth, layer > 0 ? layer - 1 : depth);
            EXPECT_EQ(on[k + 3].depth, layer > 0 ? layer : depth - 1);
          }
        });
  }

  const MeshSource& mesh_;
  std::map<std::int64_t, OnLine> of_node_;
  std::set<std::int64_t> of_layers_;  // nodes of cells of layers
  int prisms_ = 0;
  int other_cells_ = 0;
};

}  // namespace tetfarm::test
