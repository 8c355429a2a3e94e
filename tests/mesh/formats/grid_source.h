/// The cube of small cubes of tests/mesh/assemble/cut_grid.h, as a mesh that was read.
#pragma once

#include "mesh/formats/mesh_source.h"
#include "tests/mesh/assemble/cut_grid.h"

namespace tetfarm {

class GridSource : public MeshSource {
 public:
  explicit GridSource(const CutGrid& grid) : patch_names_(grid.surface.patch_names) {
    const Numbering numbering = grid.numbering();
    const ReadPortion read = grid.reader();
    for (const LeafNumbers& leaf : numbering.leaves) parts.push_back(read(leaf).part);
    nodes = numbering.nodes;
  }
  std::size_t size() const override { return parts.size(); }
  NumberedPart part(std::size_t i) const override { return parts.at(i); }
  std::vector<std::string> patch_names() const override { return patch_names_; }
  std::vector<std::string> region_names() const override { return {}; }

  std::vector<NumberedPart> parts;
  std::int64_t nodes = 0;

 private:
  std::vector<std::string> patch_names_;
};

/// What a mesh is, however its parts are: tets and boundary triangles by the places of their nodes,
/// sorted.
struct MeshContent {
  std::vector<std::array<Vec3, 4>> tets;
  std::vector<std::pair<std::array<Vec3, 3>, std::int32_t>> faces;
  friend bool operator==(const MeshContent&, const MeshContent&) = default;
};

inline bool comes_first(const Vec3& a, const Vec3& b) {
  return std::array{a.x, a.y, a.z} < std::array{b.x, b.y, b.z};
}

template <std::size_t N>
bool places_before(const std::array<Vec3, N>& a, const std::array<Vec3, N>& b) {
  return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end(), comes_first);
}

inline MeshContent content_of(const MeshSource& source) {
  MeshContent content;
  for (std::size_t i = 0; i < source.size(); ++i) {
    const NumberedPart part = source.part(i);
    const auto at = [&](std::int32_t v) { return part.nodes[static_cast<std::size_t>(v)]; };
    for (const Tet& t : part.tets) {
      content.tets.push_back({at(t[0]), at(t[1]), at(t[2]), at(t[3])});
    }
    for (std::size_t f = 0; f < part.faces.size(); ++f) {
      std::array<Vec3, 3> face = {at(part.faces[f][0]), at(part.faces[f][1]), at(part.faces[f][2])};
      std::rotate(face.begin(), std::min_element(face.begin(), face.end(), comes_first),
                  face.end());
      content.faces.emplace_back(face, part.patch_of_face[f]);
    }
  }
  std::sort(content.tets.begin(), content.tets.end(), places_before<4>);
  std::sort(content.faces.begin(), content.faces.end(),
            [](const auto& a, const auto& b) { return places_before<3>(a.first, b.first); });
  return content;
}

}  // namespace tetfarm
