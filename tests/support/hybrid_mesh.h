/// A mesh of every type of cell, made by hand: two hexes one above the other, a prism as a roof on
/// the upper one, a pyramid on two of its sides, and a tet on one of the pyramids. Two parts: hexes
/// and prism, pyramids and tet.
#pragma once

#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <vector>

#include "mesh/formats/mesh_source.h"

namespace tetfarm {

class HybridMesh : public MeshSource {
 public:
  /// With two regions the quads between the parts are boundary faces, once for each.
  explicit HybridMesh(int regions = 1) : regions_(regions) {
    const std::array cells = {Cell{ElementType::hex, {0, 1, 2, 3, 4, 5, 6, 7}},
                              Cell{ElementType::hex, {12, 13, 14, 15, 0, 1, 2, 3}},
                              Cell{ElementType::prism, {4, 7, 10, 5, 6, 11}},
                              Cell{ElementType::pyramid, {1, 2, 6, 5, 8}},
                              Cell{ElementType::pyramid, {0, 4, 7, 3, 16}},
                              Cell{ElementType::tet, {1, 2, 8, 9}}};
    count_faces(cells);
    for (const std::size_t first : {0U, 3U}) {
      add_part({cells.begin() + first, cells.begin() + first + 3});
    }
  }

  std::size_t size() const override { return parts.size(); }
  NumberedPart part(std::size_t i) const override { return parts.at(i); }
  std::vector<std::string> patch_names() const override { return {"body", "wings", "floor"}; }
  std::vector<std::string> region_names() const override {
    return regions_ == 1 ? std::vector<std::string>{"domain"}
                         : std::vector<std::string>{"inside", "outside"};
  }

  std::vector<NumberedPart> parts;
  static constexpr double volume = 2 + 0.5 + 2.0 / 3 + 5.0 / 24;

 private:
  struct Cell {
    ElementType type;
    std::vector<std::int64_t> nodes;
  };
  using FaceKey = std::vector<std::int64_t>;

  static std::vector<Vec3> places() {
    return {{0, 0, 0},  {1, 0, 0},  {1, 1, 0},     {0, 1, 0},      {0, 0, 1},     {1, 0, 1},
            {1, 1, 1},  {0, 1, 1},  {2, 0.5, 0.5}, {1.5, 0.5, -1}, {0, 0.5, 2},   {1, 0.5, 2},
            {0, 0, -1}, {1, 0, -1}, {1, 1, -1},    {0, 1, -1},     {-1, 0.5, 0.5}};
  }

  static FaceKey key(std::span<const std::int64_t> face) {
    FaceKey nodes(face.begin(), face.end());
    std::sort(nodes.begin(), nodes.end());
    return nodes;
  }

  template <class Cells>
  void count_faces(const Cells& cells) {
    for (const Cell& cell : cells) {
      for_each_face_of(
          cell.type, std::span<const std::int64_t>(cell.nodes),
          [this](ElementType, std::span<const std::int64_t> face) { ++uses_[key(face)]; });
    }
  }

  void add_part(const std::vector<Cell>& cells) {
    NumberedPart part;
    part.number = static_cast<std::int32_t>(parts.size());
    part.region = regions_ == 1 ? 1 : part.number + 1;
    for (const Cell& cell : cells) {
      part.local2global.insert(part.local2global.end(), cell.nodes.begin(), cell.nodes.end());
    }
    std::sort(part.local2global.begin(), part.local2global.end());
    part.local2global.erase(std::unique(part.local2global.begin(), part.local2global.end()),
                            part.local2global.end());
    for (const std::int64_t node : part.local2global) {
      part.nodes.push_back(places()[static_cast<std::size_t>(node)]);
    }
    for (const Cell& cell : cells) add_cell(cell, part);
    for (const Cell& cell : cells) add_boundary(cell, part);
    parts.push_back(std::move(part));
  }

  static std::int32_t local(std::int64_t node, const NumberedPart& part) {
    return static_cast<std::int32_t>(
        std::lower_bound(part.local2global.begin(), part.local2global.end(), node) -
        part.local2global.begin());
  }

  static void add_cell(const Cell& cell, NumberedPart& part) {
    if (cell.type == ElementType::tet) {
      Tet& tet = part.tets.emplace_back();
      for (std::size_t k = 0; k < 4; ++k) tet[k] = local(cell.nodes[k], part);
      return;
    }
    ElementBlock& block = part.blocks[cell.type];
    for (const std::int64_t node : cell.nodes) block.nodes.push_back(local(node, part));
    block.regions.push_back(part.region);
  }

  /// The body is all of the first part but its floor: quads, and the gables of the roof.
  void add_boundary(const Cell& cell, NumberedPart& part) const {
    for_each_face_of(
        cell.type, std::span<const std::int64_t>(cell.nodes),
        [&](ElementType type, std::span<const std::int64_t> face) {
          const bool is_between_parts = type == ElementType::quad && is_base(face);
          if (uses_.at(key(face)) == 2 && !(regions_ == 2 && is_between_parts)) return;
          const bool is_floor = face[0] >= 12 && face[1] >= 12 && face[2] >= 12;
          const std::int32_t patch = is_floor ? 2 : part.number == 1 && face.size() == 3 ? 1 : 0;
          if (type == ElementType::triangle) {
            part.faces.push_back(
                {local(face[0], part), local(face[1], part), local(face[2], part)});
            part.patch_of_face.push_back(patch);
            return;
          }
          ElementBlock& quads = part.blocks[type];
          for (const std::int64_t node : face) quads.nodes.push_back(local(node, part));
          quads.regions.push_back(part.region);
          quads.patches.push_back(patch);
        });
  }

  static bool is_base(std::span<const std::int64_t> face) {
    return key(face) == FaceKey{1, 2, 5, 6} || key(face) == FaceKey{0, 3, 4, 7};
  }

  int regions_;
  std::map<FaceKey, int> uses_;
};

}  // namespace tetfarm
