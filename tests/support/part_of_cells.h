/// A part of a mesh out of cells of any type that are listed by global nodes.
#pragma once

#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "mesh/assemble/portion.h"

namespace tetfarm {

struct ListedCell {
  ElementType type;
  std::vector<std::int64_t> nodes;
};

/// A face whichever node it begins with and whichever side is seen.
using FaceKey = std::vector<std::int64_t>;

inline FaceKey face_key(std::span<const std::int64_t> face) {
  FaceKey nodes(face.begin(), face.end());
  std::sort(nodes.begin(), nodes.end());
  return nodes;
}

/// Of each face of the cells, how many of them have it; added to `uses`.
template <class Cells>
void count_face_uses(const Cells& cells, std::map<FaceKey, int>& uses) {
  for (const ListedCell& cell : cells) {
    for_each_face_of(
        cell.type, std::span<const std::int64_t>(cell.nodes),
        [&](ElementType, std::span<const std::int64_t> face) { ++uses[face_key(face)]; });
  }
}

inline std::int32_t local_number(std::int64_t node, const NumberedPart& part) {
  return static_cast<std::int32_t>(
      std::lower_bound(part.local2global.begin(), part.local2global.end(), node) -
      part.local2global.begin());
}

inline void add_listed_cell(const ListedCell& cell, NumberedPart& part) {
  if (cell.type == ElementType::tet) {
    Tet& tet = part.tets.emplace_back();
    for (std::size_t k = 0; k < 4; ++k) tet[k] = local_number(cell.nodes[k], part);
    return;
  }
  ElementBlock& block = part.blocks[cell.type];
  for (const std::int64_t node : cell.nodes) block.nodes.push_back(local_number(node, part));
  block.regions.push_back(part.region);
}

inline void add_listed_face(ElementType type, std::span<const std::int64_t> face,
                            std::int32_t patch, NumberedPart& part) {
  if (type == ElementType::triangle) {
    part.faces.push_back(
        {local_number(face[0], part), local_number(face[1], part), local_number(face[2], part)});
    part.patch_of_face.push_back(patch);
    return;
  }
  ElementBlock& quads = part.blocks[type];
  for (const std::int64_t node : face) quads.nodes.push_back(local_number(node, part));
  quads.regions.push_back(part.region);
  quads.patches.push_back(patch);
}

/// `patch_of(type, face)` is the patch of a boundary face, nothing for others.
template <class PatchOf>
NumberedPart part_of_cells(const std::vector<ListedCell>& cells, const std::vector<Vec3>& places,
                           std::int32_t number, std::int32_t region, const PatchOf& patch_of) {
  NumberedPart part;
  part.number = number;
  part.region = region;
  for (const ListedCell& cell : cells) {
    part.local2global.insert(part.local2global.end(), cell.nodes.begin(), cell.nodes.end());
  }
  std::sort(part.local2global.begin(), part.local2global.end());
  part.local2global.erase(std::unique(part.local2global.begin(), part.local2global.end()),
                          part.local2global.end());
  for (const std::int64_t node : part.local2global) {
    part.nodes.push_back(places[static_cast<std::size_t>(node)]);
  }
  for (const ListedCell& cell : cells) add_listed_cell(cell, part);
  for (const ListedCell& cell : cells) {
    for_each_face_of(cell.type, std::span<const std::int64_t>(cell.nodes),
                     [&](ElementType type, std::span<const std::int64_t> face) {
                       const std::optional<std::int32_t> patch = patch_of(type, face);
                       if (patch) add_listed_face(type, face, *patch, part);
                     });
  }
  return part;
}

}  // namespace tetfarm
