/// A mesh of every type of cell, made by hand: two hexes one above the other, a prism as a roof on
/// the upper one, a pyramid on two of its sides, and a tet on one of the pyramids. Two parts: hexes
/// and prism, pyramids and tet.
#pragma once

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "mesh/formats/mesh_source.h"
#include "tests/support/part_of_cells.h"

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
    count_face_uses(cells, uses_);
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
  using Cell = ListedCell;

  static std::vector<Vec3> places() {
    return {{0, 0, 0},  {1, 0, 0},  {1, 1, 0},     {0, 1, 0},      {0, 0, 1},     {1, 0, 1},
            {1, 1, 1},  {0, 1, 1},  {2, 0.5, 0.5}, {1.5, 0.5, -1}, {0, 0.5, 2},   {1, 0.5, 2},
            {0, 0, -1}, {1, 0, -1}, {1, 1, -1},    {0, 1, -1},     {-1, 0.5, 0.5}};
  }

  /// The body is all of the first part but its floor: quads, and the gables of the roof.
  void add_part(const std::vector<Cell>& cells) {
    const auto number = static_cast<std::int32_t>(parts.size());
    const auto patch_of = [&](ElementType type, std::span<const std::int64_t> face) {
      std::optional<std::int32_t> patch;
      const bool is_between_parts = type == ElementType::quad && is_base(face);
      if (uses_.at(face_key(face)) == 2 && !(regions_ == 2 && is_between_parts)) return patch;
      const bool is_floor = face[0] >= 12 && face[1] >= 12 && face[2] >= 12;
      patch = is_floor ? 2 : number == 1 && face.size() == 3 ? 1 : 0;
      return patch;
    };
    parts.push_back(
        part_of_cells(cells, places(), number, regions_ == 1 ? 1 : number + 1, patch_of));
  }

  static bool is_base(std::span<const std::int64_t> face) {
    return face_key(face) == FaceKey{1, 2, 5, 6} || face_key(face) == FaceKey{0, 3, 4, 7};
  }

  int regions_;
  std::map<FaceKey, int> uses_;
};

}  // namespace tetfarm
