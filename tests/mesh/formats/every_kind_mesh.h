/// Two small meshes with a bit of everything that a format has to keep: what the tests of whole
/// files are written from.
#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "mesh/formats/regions_of_faces.h"
#include "tests/support/hybrid_mesh.h"

namespace tetfarm {

/// Puts the nodes of the part into the opposite order.
inline void turn_node_order(NumberedPart& part) {
  const auto last = static_cast<std::int32_t>(part.nodes.size()) - 1;
  const auto turn = [last](auto& nodes) {
    for (std::int32_t& v : nodes) v = last - v;
  };
  std::reverse(part.nodes.begin(), part.nodes.end());
  std::reverse(part.local2global.begin(), part.local2global.end());
  for (Tet& tet : part.tets) turn(tet);
  for (Triangle& face : part.faces) turn(face);
  for_each_block(part.blocks, [&](ElementType, ElementBlock& block) { turn(block.nodes); });
}

/// Every type of cell in three parts and three regions: the HybridMesh with one of its pyramids in
/// a region of its own, and a part of two tets in two regions, of which one touches a pyramid in a
/// node. Patches have triangles and quads, one has neither.
class EveryKindMesh : public MeshSource {
 public:
  EveryKindMesh() : parts(HybridMesh(2).parts) {
    NumberedPart& pyramids = parts[1];
    pyramids.blocks[ElementType::pyramid].regions = {2, 3};
    pyramids.region_of_tet = {2};
    set_regions_of_faces(pyramids);
    add_two_tets();
  }
  std::size_t size() const override { return parts.size(); }
  NumberedPart part(std::size_t i) const override { return parts.at(i); }
  std::vector<std::string> patch_names() const override {
    return {"body", "wing tips", "floor", "no \"face\""};
  }
  std::vector<std::string> region_names() const override { return {"inside", "far away", "top"}; }

  std::vector<NumberedPart> parts;

 private:
  void add_two_tets() {
    std::vector<Vec3> places(24);
    places[8] = {2, 0.5, 0.5};
    places[17] = {3, 0.5, 0.5};
    places[18] = {2, 1.5, 0.5};
    places[19] = {2, 0.5, 1.5};
    places[20] = {5, 0, 0};
    places[21] = {6, 0, 0};
    places[22] = {5, 1, 0};
    places[23] = {5, 0, 1e-7};
    const std::vector<ListedCell> cells = {{ElementType::tet, {8, 17, 18, 19}},
                                           {ElementType::tet, {20, 21, 22, 23}}};
    parts.push_back(
        part_of_cells(cells, places, 2, 1, [](ElementType, std::span<const std::int64_t> face) {
          const bool is_of_second = face[0] >= 20;
          const bool has_apex = std::find(face.begin(), face.end(), 23) != face.end();
          return std::optional<std::int32_t>(is_of_second ? (has_apex ? 0 : 2) : 1);
        }));
    parts[2].region_of_tet = {1, 3};
    set_regions_of_faces(parts[2]);
    turn_node_order(parts[2]);
  }
};

/// With a fourth part that has a hex, below those of the first, a prism and a pyramid again: types
/// of cells and faces that several parts have.
class ScatteredMesh : public EveryKindMesh {
 public:
  ScatteredMesh() {
    std::vector<Vec3> places(39);
    const std::array<Vec3, 4> base = {Vec3{0, 0, -1}, Vec3{1, 0, -1}, Vec3{1, 1, -1},
                                      Vec3{0, 1, -1}};
    for (std::size_t i = 0; i < 4; ++i) {
      places[12 + i] = base[i];
      places[24 + i] = base[i] - Vec3{0, 0, 1};
      places[34 + i] = base[i] + Vec3{8, 0, 0};
    }
    for (std::size_t i = 0; i < 3; ++i) {
      places[28 + i] = base[i] + Vec3{5, 0, -4};
      places[31 + i] = base[i] + Vec3{5, 0, -3};
    }
    places[38] = {8.5, 0.5, 0.25};
    const std::vector<ListedCell> cells = {{ElementType::hex, {24, 25, 26, 27, 12, 13, 14, 15}},
                                           {ElementType::prism, {28, 29, 30, 31, 32, 33}},
                                           {ElementType::pyramid, {34, 35, 36, 37, 38}}};
    parts.push_back(
        part_of_cells(cells, places, 3, 2, [](ElementType, std::span<const std::int64_t> face) {
          return std::optional<std::int32_t>(face.size() == 4 && face[0] < 28 ? 2 : 1);
        }));
    set_regions_of_faces(parts[3]);
  }
};

/// Three tets in a row, in two parts and two regions.
class TetsMesh : public MeshSource {
 public:
  TetsMesh() {
    const std::vector<Vec3> places = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0},
                                      {0, 0, 1}, {1, 1, 1}, {1, 1, -0.125}};
    const std::vector<ListedCell> first = {{ElementType::tet, {0, 1, 2, 3}},
                                           {ElementType::tet, {1, 2, 3, 4}}};
    const std::vector<ListedCell> second = {{ElementType::tet, {1, 2, 4, 5}}};
    std::map<FaceKey, int> uses;
    count_face_uses(first, uses);
    count_face_uses(second, uses);
    const auto patch_of = [&](ElementType, std::span<const std::int64_t> face) {
      std::optional<std::int32_t> patch;
      if (uses.at(face_key(face)) == 1) patch = face_key(face).back() >= 4 ? 1 : 0;
      return patch;
    };
    parts.push_back(part_of_cells(first, places, 0, 1, patch_of));
    parts[0].region_of_tet = {1, 2};
    set_regions_of_faces(parts[0]);
    parts.push_back(part_of_cells(second, places, 1, 2, patch_of));
  }
  std::size_t size() const override { return parts.size(); }
  NumberedPart part(std::size_t i) const override { return parts.at(i); }
  std::vector<std::string> patch_names() const override { return {"low", "high"}; }
  std::vector<std::string> region_names() const override { return {"water", "air"}; }

  std::vector<NumberedPart> parts;
};

}  // namespace tetfarm
