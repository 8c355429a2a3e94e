#include "mesh/formats/used_vertices.h"

#include <string>

namespace tetfarm {

void keep_used_vertices(SurfaceMesh& surface) {
  std::vector<std::int32_t> old2new(surface.vertices.size(), -1);
  const auto slot = [&](std::int32_t v) -> std::int32_t& {
    return old2new[static_cast<std::size_t>(v)];
  };
  for (const Triangle& triangle : surface.triangles) {
    for (const std::int32_t v : triangle) slot(v) = 0;
  }
  std::size_t kept = 0;
  for (std::size_t v = 0; v < old2new.size(); ++v) {
    if (old2new[v] < 0) continue;
    old2new[v] = static_cast<std::int32_t>(kept);
    surface.vertices[kept++] = surface.vertices[v];
  }
  surface.vertices.resize(kept);
  for (Triangle& triangle : surface.triangles) {
    for (std::int32_t& v : triangle) v = slot(v);
  }
}

std::int32_t vertex_of(const InputScanner& scanner, const SurfaceMesh& surface, std::int64_t number,
                       std::int64_t from) {
  const auto count = static_cast<std::int64_t>(surface.vertices.size());
  if (number < from || number - from >= count) {
    scanner.fail("vertex " + std::to_string(number) + " of " + std::to_string(count) +
                 " (counted from " + std::to_string(from) + ")");
  }
  return static_cast<std::int32_t>(number - from);
}

}  // namespace tetfarm
