#include "cli/small_patches.h"

#include <algorithm>

namespace tetfarm {

std::vector<std::string> small_patches(const MeshSource& mesh) {
  const std::vector<std::string> names = mesh.patch_names();
  const auto is_made = [](const std::string& name) { return name.starts_with("outer_"); };
  if (std::any_of(names.begin(), names.end(), is_made)) return {};
  std::vector<Box3> boxes(names.size());
  Box3 all;
  for (std::size_t i = 0; i < mesh.size(); ++i) {
    const NumberedPart part = mesh.part(i);
    for (std::size_t f = 0; f < part.faces.size(); ++f) {
      const auto patch = static_cast<std::size_t>(part.patch_of_face[f]);
      if (patch >= boxes.size()) continue;
      for (const std::int32_t v : part.faces[f]) {
        boxes[patch].add(part.nodes[static_cast<std::size_t>(v)]);
      }
    }
  }
  for (const Box3& box : boxes) {
    if (!box.empty()) all.add(box);
  }
  std::vector<std::string> small;
  for (std::size_t patch = 0; patch < boxes.size(); ++patch) {
    const bool is_small =
        !boxes[patch].empty() && norm(boxes[patch].size()) < 0.4 * norm(all.size());
    if (is_small) small.push_back(names[patch]);
  }
  return small;
}

}  // namespace tetfarm
