#include "mesh/shapes/patched_surface.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/check.h"
#include "base/error.h"
#include "mesh/core/complaints.h"

namespace tetfarm {

void PatchedSurface::begin_patch(const std::string& name) { mesh_.patch_names.push_back(name); }

std::int32_t PatchedSurface::add_vertex(const Vec3& p) {
  mesh_.vertices.push_back(p);
  return static_cast<std::int32_t>(mesh_.vertices.size() - 1);
}

void PatchedSurface::add_triangle(std::int32_t a, std::int32_t b, std::int32_t c) {
  TF_CHECK(std::min({a, b, c}) >= 0 &&
           static_cast<std::size_t>(std::max({a, b, c})) < mesh_.vertices.size());
  TF_CHECK(!mesh_.patch_names.empty());
  mesh_.triangles.push_back({a, b, c});
  mesh_.patch_of_triangle.push_back(static_cast<std::int32_t>(mesh_.patch_names.size() - 1));
}

void PatchedSurface::add_surface(const SurfaceMesh& surface, bool turned) {
  const auto first = static_cast<std::int32_t>(mesh_.vertices.size());
  mesh_.vertices.insert(mesh_.vertices.end(), surface.vertices.begin(), surface.vertices.end());
  for (const auto& [a, b, c] : surface.triangles) {
    add_triangle(first + a, first + (turned ? c : b), first + (turned ? b : c));
  }
}

void PatchedSurface::zip(const VertexRow& left, const VertexRow& right) {
  TF_CHECK(!left.empty() && !right.empty());
  std::size_t i = 0;
  std::size_t j = 0;
  while (i + 1 < left.size() || j + 1 < right.size()) {
    bool along_left = j + 1 == right.size();
    if (i + 1 < left.size() && !along_left) {
      const double to_left = norm2(at(left[i + 1]) - at(right[j]));
      const double to_right = norm2(at(right[j + 1]) - at(left[i]));
      along_left = to_left < to_right ||
                   (to_left == to_right && i * (right.size() - 1) <= j * (left.size() - 1));
    }
    if (along_left) {
      add_triangle(left[i], right[j], left[i + 1]);
      ++i;
    } else {
      add_triangle(left[i], right[j], right[j + 1]);
      ++j;
    }
  }
}

void PatchedSurface::zip_rings(VertexRow left, VertexRow right) {
  for (VertexRow* ring : {&left, &right}) {
    if (ring->size() > 1) ring->push_back(ring->front());
  }
  zip(left, right);
}

int parts_of_length(double length, double spacing, int least, const std::string& option) {
  TF_CHECK(least > 0);
  constexpr double most = 20'000;
  const double parts = std::floor(length / spacing + 0.5);
  if (!(spacing > 0) || !(parts <= most)) {
    throw UsageError(
        "the spacing " + text_of(spacing) + " is too small for a length of " + text_of(length),
        option);
  }
  return std::max(least, static_cast<int>(parts));
}

}  // namespace tetfarm
