/// The cells of a part and their faces, of every type, counted as one row: tets, then each type of
/// block. Boundary faces are counted in the same way: triangles, then each type of block.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "base/check.h"
#include "mesh/assemble/portion.h"
#include "mesh/core/face_nodes.h"

namespace tetfarm {

/// How many elements each block has.
inline ElementCounts counts_of(const ElementBlocks& blocks) {
  ElementCounts counts{};
  for_each_block(blocks, [&counts](ElementType type, const ElementBlock& block) {
    counts[type] = std::ssize(block.regions);
  });
  return counts;
}

/// Calls visit(cell, type, nodes) for each cell.
template <class Visit>
void for_each_cell(const NumberedPart& part, const Visit& visit) {
  TF_CHECK(cells_of(part) <= std::numeric_limits<std::int32_t>::max());
  std::int32_t cell = 0;
  for (const Tet& tet : part.tets) {
    visit(cell++, ElementType::tet, std::span<const std::int32_t>(tet));
  }
  for_each_block_cell(part.blocks, [&](ElementType type, std::span<const std::int32_t> nodes,
                                       std::int32_t) { visit(cell++, type, nodes); });
}

/// Calls visit(cell, face) for each face of each cell, the normal outwards.
template <class Visit>
void for_each_face_of_cells(const NumberedPart& part, const Visit& visit) {
  for_each_cell(
      part, [&](std::int32_t cell, ElementType type, std::span<const std::int32_t> nodes) {
        for_each_face_of(type, nodes, [&](ElementType, std::span<const std::int32_t> face) {
          visit(cell, FaceNodes<std::int32_t>(face));
        });
      });
}

/// Calls visit(number, face, patch) for each boundary face, the normal outwards.
template <class Visit>
void for_each_boundary_face(const NumberedPart& part, const Visit& visit) {
  TF_CHECK(part.patch_of_face.size() == part.faces.size());
  std::int32_t number = 0;
  for (const Triangle& face : part.faces) {
    visit(number, FaceNodes<std::int32_t>(face),
          part.patch_of_face[static_cast<std::size_t>(number)]);
    ++number;
  }
  for_each_block_face(part.blocks, [&](ElementType, std::span<const std::int32_t> face,
                                       std::int32_t, std::int32_t patch) {
    visit(number++, FaceNodes<std::int32_t>(face), patch);
  });
}

/// The cells of a block of that type in another order: first the one that order[0] is the number
/// of.
/// @pre `order` has each number once.
inline ElementBlock reordered(ElementType type, const ElementBlock& cells,
                              const std::vector<std::size_t>& order) {
  TF_CHECK(order.size() == cells.size());
  ElementBlock result;
  result.nodes.reserve(cells.nodes.size());
  result.regions.reserve(order.size());
  for (const std::size_t i : order) {
    const std::span<const std::int32_t> nodes = cells.element(type, i);
    result.nodes.insert(result.nodes.end(), nodes.begin(), nodes.end());
    result.regions.push_back(cells.regions[i]);
  }
  return result;
}

/// Of each boundary face.
inline std::vector<std::int32_t> patches_of_boundary(const NumberedPart& part) {
  std::vector<std::int32_t> patches;
  for_each_boundary_face(part, [&](std::int32_t, const FaceNodes<std::int32_t>&,
                                   std::int32_t patch) { patches.push_back(patch); });
  return patches;
}

}  // namespace tetfarm
