#include "mesh/formats/regions_of_faces.h"

#include <algorithm>
#include <utility>

#include "base/array_index.h"
#include "base/check.h"

namespace tetfarm {
namespace {

/// The smallest number first, turning the same way round.
template <std::size_t N>
std::array<std::int32_t, N> smallest_first(std::array<std::int32_t, N> face) {
  std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
  return face;
}

/// Boundary faces with N nodes, found by them.
template <std::size_t N>
class WantedFaces {
 public:
  using Face = std::array<std::int32_t, N>;

  void add(const Face& face) { wanted_.emplace_back(smallest_first(face), wanted_.size()); }
  void sort() { std::sort(wanted_.begin(), wanted_.end()); }
  /// Sets the region of each that is this face of a cell.
  void found(const Face& nodes, std::int32_t region, std::vector<std::int32_t>& regions) const {
    const Face face = smallest_first(nodes);
    auto same = std::lower_bound(wanted_.begin(), wanted_.end(), std::pair(face, std::size_t{0}));
    for (; same != wanted_.end() && same->first == face; ++same) regions[same->second] = region;
  }

 private:
  std::vector<std::pair<Face, std::size_t>> wanted_;
};

}  // namespace

void set_regions_of_faces(NumberedPart& part) {
  TF_CHECK(part.region_of_tet.size() == part.tets.size());
  WantedFaces<3> triangles;
  for (const Triangle& face : part.faces) triangles.add(face);
  triangles.sort();
  ElementBlock& boundary_quads = part.blocks[ElementType::quad];
  WantedFaces<4> quads;
  for (std::size_t i = 0; i < boundary_quads.size(); ++i) {
    const auto nodes = boundary_quads.element(ElementType::quad, i);
    quads.add({nodes[0], nodes[1], nodes[2], nodes[3]});
  }
  quads.sort();
  part.region_of_face.assign(part.faces.size(), part.region);
  for (std::size_t t = 0; t < part.tets.size(); ++t) {
    const Tet& tet = part.tets[t];
    for (const auto& [i, j, k] : tet_face_nodes) {
      triangles.found({tet[at(i)], tet[at(j)], tet[at(k)]}, part.region_of(t), part.region_of_face);
    }
  }
  for_each_block_cell(
      part.blocks, [&](ElementType type, std::span<const std::int32_t> cell, std::int32_t region) {
        for_each_face_of(type, cell, [&](ElementType, std::span<const std::int32_t> face) {
          if (face.size() == 3) {
            triangles.found({face[0], face[1], face[2]}, region, part.region_of_face);
          } else {
            quads.found({face[0], face[1], face[2], face[3]}, region, boundary_quads.regions);
          }
        });
      });
}

}  // namespace tetfarm
