#include "mesh/formats/stl/write_stl.h"

#include <cstddef>

#include "base/check.h"
#include "mesh/formats/coordinate_text.h"
#include "mesh/formats/patch_names.h"

namespace tetfarm {
namespace {

/// Few facets have more: a text that grows by doubling would be in memory twice.
constexpr std::size_t facet_bytes = 320;

void append_facet(std::string& text, const Vec3& a, const Vec3& b, const Vec3& c) {
  text += "facet normal ";
  append_coordinates(text, normalized(cross(b - a, c - a)));
  text += "outer loop\n";
  for (const Vec3& p : {a, b, c}) {
    text += "vertex ";
    append_coordinates(text, p);
  }
  text += "endloop\nendfacet\n";
}

}  // namespace

std::string write_stl(const SurfaceMesh& surface) {
  const auto at = [&](std::int32_t v) { return surface.vertices[static_cast<std::size_t>(v)]; };
  const bool has_patches = !surface.patch_of_triangle.empty();
  const std::size_t patches = has_patches ? surface.patch_names.size() : 1;
  TF_CHECK(!has_patches || surface.patch_of_triangle.size() == surface.triangles.size());
  std::string text;
  text.reserve(facet_bytes * surface.triangles.size());
  for (std::size_t patch = 0; patch < patches; ++patch) {
    const std::string name = has_patches ? surface.patch_names[patch] : std::string(unnamed_patch);
    text += "solid " + name + "\n";
    for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
      if (has_patches && surface.patch_of_triangle[t] != static_cast<std::int32_t>(patch)) continue;
      const auto& [a, b, c] = surface.triangles[t];
      append_facet(text, at(a), at(b), at(c));
    }
    text += "endsolid " + name + "\n";
  }
  return text;
}

}  // namespace tetfarm
