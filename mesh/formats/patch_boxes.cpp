#include "mesh/formats/patch_boxes.h"

#include <algorithm>

#include "mesh/assemble/part_cells.h"

namespace tetfarm {

std::vector<Box3> patch_boxes(const MeshSource& source, const MeshOutline& outline) {
  std::vector<Box3> boxes(outline.patch_names.size());
  for (std::size_t i = 0; i < source.size(); ++i) {
    const NumberedPart part = source.part(i);
    for_each_boundary_face(
        part, [&](std::int32_t, const FaceNodes<std::int32_t>& face, std::int32_t patch) {
          for (const std::int32_t v : face) {
            boxes.at(static_cast<std::size_t>(patch)).add(part.nodes[static_cast<std::size_t>(v)]);
          }
        });
  }
  return boxes;
}

std::vector<Box3> patch_boxes(const SurfaceMesh& surface) {
  std::vector<Box3> boxes(std::max<std::size_t>(1, surface.patch_names.size()));
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    Box3& box = boxes.at(static_cast<std::size_t>(patch_of(surface, t)));
    for (const std::int32_t v : surface.triangles[t]) {
      box.add(surface.vertices[static_cast<std::size_t>(v)]);
    }
  }
  return boxes;
}

std::optional<int> constant_axis(const Box3& box) {
  if (box.empty()) return std::nullopt;
  constexpr double rounding = 1e-6;
  const Vec3 size = box.size();
  const double most = rounding * std::max({size.x, size.y, size.z});
  std::optional<int> flat;
  for (int axis = 0; axis < 3; ++axis) {
    if (size[axis] > most) continue;
    if (flat) return std::nullopt;
    flat = axis;
  }
  return flat;
}

}  // namespace tetfarm
