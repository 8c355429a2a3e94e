#include "mesh/render/part_faces.h"

#include <algorithm>
#include <utility>

#include "base/check.h"
#include "mesh/core/sorted_face.h"

namespace tetfarm {
namespace {

/// Calls visit(triangle) for a triangle, or for the halves of a quad, which are the same ones from
/// either side.
template <class Visit>
void for_each_half(std::span<const std::int32_t> face, const Visit& visit) {
  if (face.size() == 3) {
    visit(Triangle{face[0], face[1], face[2]});
    return;
  }
  const auto lowest =
      static_cast<std::size_t>(std::min_element(face.begin(), face.end()) - face.begin());
  const auto corner = [&](std::size_t k) { return face[(lowest + k) % 4]; };
  visit(Triangle{corner(0), corner(1), corner(2)});
  visit(Triangle{corner(0), corner(2), corner(3)});
}

}  // namespace

std::vector<ShownFace> surface_faces(const NumberedPart& part) {
  TF_CHECK(part.patch_of_face.size() == part.faces.size());
  std::vector<ShownFace> faces;
  for (std::size_t i = 0; i < part.faces.size(); ++i) {
    faces.push_back({part.faces[i], part.patch_of_face[i], part.region_of_boundary(i)});
  }
  for_each_block_face(part.blocks, [&](ElementType, std::span<const std::int32_t> face,
                                       std::int32_t region, std::int32_t patch) {
    for_each_half(face, [&](const Triangle& half) { faces.push_back({half, patch, region}); });
  });
  return faces;
}

std::vector<ShownFace> outer_faces(const NumberedPart& part, const std::vector<bool>& is_kept) {
  TF_CHECK(is_kept.size() >= part.tets.size());
  std::vector<std::pair<Triangle, std::size_t>> all;  // with their cells
  for (std::size_t t = 0; t < part.tets.size(); ++t) {
    if (!is_kept[t]) continue;
    for (const auto& [i, j, k] : tet_face_nodes) {
      const auto node = [&](int n) { return part.tets[t][static_cast<std::size_t>(n)]; };
      all.emplace_back(sorted_face(Triangle{node(i), node(j), node(k)}), t);
    }
  }
  std::size_t cell = part.tets.size();
  for_each_block_cell(part.blocks, [&](ElementType type, std::span<const std::int32_t> nodes,
                                       std::int32_t) {
    const std::size_t here = cell++;
    TF_CHECK(here < is_kept.size());
    if (!is_kept[here]) return;
    for_each_face_of(type, nodes, [&](ElementType, std::span<const std::int32_t> face) {
      for_each_half(face, [&](const Triangle& half) { all.emplace_back(sorted_face(half), here); });
    });
  });
  TF_CHECK(cell == is_kept.size());
  const std::vector<std::int32_t> regions = regions_of_cells(part);
  std::sort(all.begin(), all.end());
  std::vector<ShownFace> surface = surface_faces(part);
  for (ShownFace& face : surface) sort_face(face.nodes);
  const auto before = [](const ShownFace& a, const ShownFace& b) { return a.nodes < b.nodes; };
  std::sort(surface.begin(), surface.end(), before);
  std::vector<ShownFace> faces;
  for (std::size_t i = 0; i < all.size();) {
    std::size_t end = i + 1;
    while (end < all.size() && all[end].first == all[i].first) ++end;
    if (end == i + 1) {
      ShownFace face{all[i].first, -1, regions[all[i].second],
                     static_cast<std::int64_t>(all[i].second)};
      const auto found = std::lower_bound(surface.begin(), surface.end(), face, before);
      if (found != surface.end() && found->nodes == face.nodes) face.patch = found->patch;
      faces.push_back(face);
    }
    i = end;
  }
  return faces;
}

}  // namespace tetfarm
