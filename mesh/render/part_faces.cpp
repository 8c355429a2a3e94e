#include "mesh/render/part_faces.h"

#include <algorithm>
#include <utility>

#include "base/check.h"

namespace tetfarm {
namespace {

Triangle sorted(Triangle nodes) {
  std::sort(nodes.begin(), nodes.end());
  return nodes;
}

}  // namespace

std::vector<ShownFace> surface_faces(const NumberedPart& part) {
  TF_CHECK(part.patch_of_face.size() == part.faces.size());
  std::vector<ShownFace> faces;
  for (std::size_t i = 0; i < part.faces.size(); ++i) {
    faces.push_back({part.faces[i], part.patch_of_face[i], part.region_of_boundary(i)});
  }
  return faces;
}

std::vector<ShownFace> outer_faces(const NumberedPart& part, const std::vector<bool>& is_kept) {
  TF_CHECK(is_kept.size() == part.tets.size());
  std::vector<std::pair<Triangle, std::size_t>> all;  // with their tets
  for (std::size_t t = 0; t < part.tets.size(); ++t) {
    if (!is_kept[t]) continue;
    for (const auto& [i, j, k] : tet_face_nodes) {
      const auto node = [&](int n) { return part.tets[t][static_cast<std::size_t>(n)]; };
      all.emplace_back(sorted({node(i), node(j), node(k)}), t);
    }
  }
  std::sort(all.begin(), all.end());
  std::vector<ShownFace> surface = surface_faces(part);
  for (ShownFace& face : surface) face.nodes = sorted(face.nodes);
  const auto before = [](const ShownFace& a, const ShownFace& b) { return a.nodes < b.nodes; };
  std::sort(surface.begin(), surface.end(), before);
  std::vector<ShownFace> faces;
  for (std::size_t i = 0; i < all.size();) {
    std::size_t end = i + 1;
    while (end < all.size() && all[end].first == all[i].first) ++end;
    if (end == i + 1) {
      ShownFace face{all[i].first, -1, part.region_of(all[i].second)};
      const auto found = std::lower_bound(surface.begin(), surface.end(), face, before);
      if (found != surface.end() && found->nodes == face.nodes) face.patch = found->patch;
      faces.push_back(face);
    }
    i = end;
  }
  return faces;
}

}  // namespace tetfarm
