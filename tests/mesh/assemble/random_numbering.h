/// Numberings of random trees, with all that a numbering can have, and questions of their leaves.
#pragma once

#include <cstdint>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "base/error.h"
#include "mesh/assemble/leaf_numbering.h"
#include "tests/support/shapes.h"

namespace tetfarm {

/// A box in which another region lies, with needles, and vertices that no triangle uses.
inline SurfaceMesh surface_of_two_regions() {
  SurfaceMesh surface = shapes::box({0, 0, 0}, {8, 8, 8}, 8);
  for (Vec3& v : surface.vertices) {
    if (v == Vec3{2, 2, 8} || v == Vec3{5, 0, 5}) v.x += 0.999;
  }
  surface.sides.assign(surface.triangles.size(), Sides{1, 0});
  const SurfaceMesh inner = shapes::box({2, 2, 2}, {5, 5, 5}, 2);
  for (int i = 0; i < 7; ++i) surface.vertices.push_back({9, 9, 9});
  const auto first = static_cast<std::int32_t>(surface.vertices.size());
  surface.vertices.insert(surface.vertices.end(), inner.vertices.begin(), inner.vertices.end());
  for (const auto& [a, b, c] : inner.triangles) {
    surface.triangles.push_back({first + a, first + b, first + c});
    surface.patch_of_triangle.push_back(0);
    surface.sides.push_back({2, 1});
  }
  surface.region_names = {"outside", "inside"};
  return surface;
}

/// Seeded: the same numbering each time.
class RandomNumbering {
 public:
  RandomNumbering(const SurfaceMesh& surface, unsigned seed, std::size_t leaves) : random_(seed) {
    counts_faces_ = pick(3) > 0;
    has_layers_ = counts_faces_ && seed % 2 == 1;
    has_quads_ = has_layers_ && seed % 4 == 1;
    grow({1}, leaves);
    numbering_ = number_globally(surface, table_);
    vertices_ = static_cast<std::uint32_t>(surface.vertices.size());
    force_some_nodes();
  }

  const Numbering& numbering() const { return numbering_; }

  /// Nodes of the surface, of cuts and of leaves that exist, in random order, some of them twice.
  std::vector<Origin> some_nodes() {
    std::vector<Origin> nodes;
    for (std::uint32_t i = pick(200); i > 0; --i) {
      const Origin origin = some_node();
      if (is_node(origin)) nodes.push_back(origin);
    }
    return nodes;
  }

  /// A node that may have been dropped, or may never have been.
  Origin some_node() {
    const std::vector<CutNumbers>& cuts = numbering_.cuts;
    const std::vector<LeafNumbers>& leaves = numbering_.leaves;
    const std::uint32_t kind = pick(4);
    if (kind == 0 && !cuts.empty()) return some_node_of(cuts[pick(cuts.size())]);
    if (kind == 1) return some_node_of(leaves[pick(leaves.size())]);
    if (kind == 2 && pick(20) == 0) return {1 + pick(4000), pick(9)};
    if (kind == 2 && pick(5) == 0) return {top_of_layers, pick(50)};
    return {0, pick(vertices_ + 3)};
  }

  bool is_node(const Origin& origin) const {
    try {
      global_number(numbering_, origin);
      return true;
    } catch (const Error&) {
      return false;
    }
  }

  TreePath some_leaf() { return numbering_.leaves[pick(numbering_.leaves.size())].path; }
  std::uint32_t pick(std::size_t below) { return static_cast<std::uint32_t>(random_() % below); }

 private:
  /// In one region, or the other, or both, whatever the surface is like.
  void force_some_nodes() {
    std::set<ForcedNode> forced;
    for (std::uint32_t i = pick(300); i > 0; --i) {
      forced.insert(
          {static_cast<std::int32_t>(pick(vertices_)), static_cast<std::int32_t>(1 + pick(2))});
    }
    numbering_.forced.assign(forced.begin(), forced.end());
  }

  template <class Owner>
  Origin some_node_of(const Owner& owner) {
    return {owner.path.heap, pick(static_cast<std::size_t>(owner.nodes.made) + 2)};
  }

  void grow(TreePath path, std::size_t leaves) {
    if (leaves > 1) {
      add_line("cut", path, pick(40));
      const std::size_t left = 1 + pick(leaves - 1);
      grow(path.left(), left);
      grow(path.right(), leaves - left);
    } else if (path.heap != 1 && last_leaf_ != 0 && pick(6) == 0) {
      table_ += "joined " + std::to_string(path.heap) + ' ' + std::to_string(last_leaf_) + '\n';
    } else {
      last_leaf_ = path.heap;
      add_line("leaf", path, pick(60));
    }
  }

  void add_line(const std::string& kind, TreePath path, std::uint32_t nodes) {
    const std::string heap = ' ' + std::to_string(path.heap) + ' ';
    table_ += kind + heap + std::to_string(nodes);
    if (kind == "leaf") {
      table_ += ' ' + std::to_string(pick(500));
      if (counts_faces_) table_ += ' ' + std::to_string(pick(30));
      if (has_layers_ && pick(3) > 0) {
        table_ += ' ' + std::to_string(pick(90)) + ' ' + std::to_string(pick(900));
        if (has_quads_ && pick(2) > 0) table_ += ' ' + std::to_string(pick(500));
      }
    }
    table_ += '\n';
    for (std::uint32_t first = pick(30); first < nodes;) {
      const std::uint32_t count = 1 + pick(nodes - first);
      table_ += "dropped" + heap + std::to_string(first) + ' ' + std::to_string(count) + '\n';
      first += count + pick(9);
    }
  }

  std::mt19937 random_;
  bool counts_faces_ = true;
  bool has_layers_ = false;
  bool has_quads_ = false;
  std::uint64_t last_leaf_ = 0;
  std::string table_;
  std::uint32_t vertices_ = 0;
  Numbering numbering_;
};

}  // namespace tetfarm
