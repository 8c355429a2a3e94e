/// Elements that the kernel does not make, as a part of a finished mesh has them.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/core/elements.h"

namespace tetfarm {

/// The types that a part has in blocks, in the order in which they are listed and counted. Tets and
/// triangles are kept as the kernel makes them.
inline constexpr std::array cell_block_types = {ElementType::pyramid, ElementType::prism,
                                                ElementType::hex};
inline constexpr std::array face_block_types = {ElementType::quad};
static_assert(2 + cell_block_types.size() + face_block_types.size() == all_element_types.size());

/// Elements of one type, one after the other.
/// Invariants: 1. `nodes` has as many for each as the type has, in our order (elements.h);
/// 2. `regions` has one for each, and so has `patches` of faces; of cells it is empty.
struct ElementBlock {
  std::vector<std::int32_t> nodes;    ///< local numbers
  std::vector<std::int32_t> regions;  ///< of a cell that it lies in, of a face that it bounds
  std::vector<std::int32_t> patches;

  std::size_t size() const { return regions.size(); }
  bool empty() const { return regions.empty(); }
  /// The nodes of the i-th. @pre the block is of that type.
  std::span<const std::int32_t> element(ElementType type, std::size_t i) const {
    return {nodes.data() + i * nodes_of(type), nodes_of(type)};
  }
};

/// None of tets and triangles.
using ElementBlocks = ByType<ElementBlock>;
using ElementCounts = ByType<std::int64_t>;

inline std::int64_t count_cells(const ElementCounts& counts) {
  std::int64_t sum = 0;
  for (const ElementType type : all_element_types) sum += is_cell(type) ? counts[type] : 0;
  return sum;
}
inline std::int64_t count_faces(const ElementCounts& counts) {
  std::int64_t sum = 0;
  for (const ElementType type : all_element_types) sum += is_cell(type) ? 0 : counts[type];
  return sum;
}

/// Calls visit(type, block) for each block, of cells and then of faces, also for empty ones.
template <class Blocks, class Visit>
void for_each_block(Blocks& blocks, const Visit& visit) {
  for (const ElementType type : cell_block_types) visit(type, blocks[type]);
  for (const ElementType type : face_block_types) visit(type, blocks[type]);
}

/// Calls visit(type, nodes, region) for each cell in blocks, type after type.
template <class Visit>
void for_each_block_cell(const ElementBlocks& blocks, const Visit& visit) {
  for (const ElementType type : cell_block_types) {
    const ElementBlock& block = blocks[type];
    for (std::size_t i = 0; i < block.size(); ++i) {
      visit(type, block.element(type, i), block.regions[i]);
    }
  }
}

/// Calls visit(type, nodes, region, patch) for each boundary face in blocks.
template <class Visit>
void for_each_block_face(const ElementBlocks& blocks, const Visit& visit) {
  for (const ElementType type : face_block_types) {
    const ElementBlock& block = blocks[type];
    for (std::size_t i = 0; i < block.size(); ++i) {
      visit(type, block.element(type, i), block.regions[i], block.patches[i]);
    }
  }
}

inline bool has_elements(const ElementBlocks& blocks) {
  bool has = false;
  for_each_block(blocks, [&](ElementType, const ElementBlock& b) { has = has || !b.empty(); });
  return has;
}

/// Calls visit(type, nodes) for each face of a cell, the normal outwards.
template <class Node, class Visit>
void for_each_face_of(ElementType type, std::span<const Node> nodes, const Visit& visit) {
  for (const ElementFace& face : element(type).faces) {
    std::array<Node, most_face_nodes> corners{};
    for (std::size_t k = 0; k < nodes_of(face.type); ++k) corners[k] = nodes[face.nodes[k]];
    visit(face.type, std::span<const Node>(corners.data(), nodes_of(face.type)));
  }
}

}  // namespace tetfarm
