#include "mesh/formats/regions_of_faces.h"

#include <algorithm>
#include <utility>

#include "base/array_index.h"
#include "base/check.h"
#include "mesh/assemble/part_cells.h"

namespace tetfarm {

void set_regions_of_faces(NumberedPart& part) {
  TF_CHECK(part.region_of_tet.size() == part.tets.size());
  using Face = FaceNodes<std::int32_t>;
  std::vector<std::pair<Face, std::size_t>> wanted;  // boundary faces, found by their nodes
  for_each_boundary_face(part, [&](std::int32_t number, const Face& face, std::int32_t) {
    wanted.emplace_back(face.smallest_first(), at(number));
  });
  std::sort(wanted.begin(), wanted.end());
  const std::vector<std::int32_t> region_of_cell = regions_of_cells(part);
  std::vector<std::int32_t> regions = regions_of_boundary(part);
  for_each_face_of_cells(part, [&](std::int32_t cell, const Face& nodes) {
    const Face face = nodes.smallest_first();
    auto same = std::lower_bound(wanted.begin(), wanted.end(), std::pair(face, std::size_t{0}));
    for (; same != wanted.end() && same->first == face; ++same) {
      regions[same->second] = region_of_cell[at(cell)];
    }
  });
  auto next = regions.begin() + std::ssize(part.faces);
  part.region_of_face.assign(regions.begin(), next);
  for (const ElementType type : face_block_types) {
    std::vector<std::int32_t>& of_block = part.blocks[type].regions;
    std::copy_n(next, of_block.size(), of_block.begin());
    next += std::ssize(of_block);
  }
}

void set_regions_from_cells(NumberedPart& part) {
  const std::vector<std::int32_t> regions = regions_of_cells(part);
  if (!regions.empty()) part.region = regions.front();
  if (std::any_of(regions.begin(), regions.end(), [&](auto r) { return r != part.region; })) {
    set_regions_of_faces(part);
    return;
  }
  part.region_of_tet.clear();
  for (const ElementType type : face_block_types) {
    std::vector<std::int32_t>& of_faces = part.blocks[type].regions;
    std::fill(of_faces.begin(), of_faces.end(), part.region);
  }
}

}  // namespace tetfarm
