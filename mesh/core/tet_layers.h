/// Layers of tets round a set of nodes: first those that have one of the nodes, then those that
/// share a node with these, and so on (thesis 4.3.4.1.2, figure 81).
///
/// A layer costs what lies near it, not all tets: tets in blocks know which pages of nodes they
/// use, and only blocks that use a page with a new node are looked at. Tets that follow each other
/// lie near each other in our meshes; of others the result is the same, but not the cost.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/core/tet_mesh.h"

namespace tetfarm {

/// Which blocks of tets use which pages of nodes.
class TetBlocks {
 public:
  static constexpr std::size_t tets_of_block = 512;
  static constexpr std::size_t nodes_of_page = 64;

  /// @pre all nodes of the tets are below `nodes`; the tets outlive this. Cost: O(tets).
  TetBlocks(std::span<const Tet> tets, std::size_t nodes);

  std::span<const Tet> tets() const { return tets_; }
  std::size_t nodes() const { return nodes_; }
  std::size_t pages() const { return nodes_ / nodes_of_page + 1; }
  std::size_t blocks() const { return first_page_.size() - 1; }
  std::span<const std::uint32_t> pages_of(std::size_t block) const {
    return std::span(pages_).subspan(first_page_[block],
                                     first_page_[block + 1] - first_page_[block]);
  }

 private:
  std::span<const Tet> tets_;
  std::size_t nodes_;
  std::vector<std::uint32_t> pages_;     ///< of all blocks, one block after the other
  std::vector<std::size_t> first_page_;  ///< of each block in pages_, and the end
};

class TetLayers {
 public:
  /// The blocks outlive this. Cost: a byte a tet and a node.
  explicit TetLayers(const TetBlocks& blocks);

  /// The next layer goes round this node, too.
  void reach(std::int32_t node);
  /// Round the nodes of these tets.
  void reach_nodes_of(std::span<const std::uint32_t> tets);

  /// The tets at nodes that were reached, ascending, without those of earlier layers.
  std::vector<std::uint32_t> next();

  /// Whether the tet is in a layer so far.
  bool has(std::uint32_t tet) const { return is_given_[tet] != 0; }

 private:
  void add_new_of(std::size_t block, std::vector<std::uint32_t>& layer);

  const TetBlocks& blocks_;
  std::vector<std::uint8_t> is_reached_;  ///< nodes; bytes, as all stay in the nearest cache
  std::vector<std::uint8_t> is_given_;    ///< tets
  std::vector<std::uint8_t> has_new_;     ///< pages with nodes reached since the last layer
};

}  // namespace tetfarm
