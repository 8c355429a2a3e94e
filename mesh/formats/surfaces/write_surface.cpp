#include "mesh/formats/surfaces/write_surface.h"

#include <array>
#include <charconv>
#include <cstddef>

#include "base/check.h"
#include "base/error.h"
#include "base/file_system.h"
#include "mesh/formats/patch_names.h"

namespace tetfarm {
namespace {

void append(std::string& text, double number) {
  std::array<char, 32> digits;
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr;
  text.append(digits.data(), end);
}

void append(std::string& text, const Vec3& p) {
  append(text, p.x);
  text += ' ';
  append(text, p.y);
  text += ' ';
  append(text, p.z);
  text += '\n';
}

void append_facet(std::string& text, const Vec3& a, const Vec3& b, const Vec3& c) {
  text += "facet normal ";
  append(text, normalized(cross(b - a, c - a)));
  text += "outer loop\n";
  for (const Vec3& p : {a, b, c}) {
    text += "vertex ";
    append(text, p);
  }
  text += "endloop\nendfacet\n";
}

}  // namespace

std::string write_off(const SurfaceMesh& surface) {
  std::string text = "OFF\n" + std::to_string(surface.vertices.size()) + " " +
                     std::to_string(surface.triangles.size()) + " 0\n";
  for (const Vec3& p : surface.vertices) append(text, p);
  for (const auto& [a, b, c] : surface.triangles) {
    text += "3 " + std::to_string(a) + " " + std::to_string(b) + " " + std::to_string(c) + "\n";
  }
  return text;
}

std::string write_stl(const SurfaceMesh& surface) {
  const auto at = [&](std::int32_t v) { return surface.vertices[static_cast<std::size_t>(v)]; };
  const bool has_patches = !surface.patch_of_triangle.empty();
  const std::size_t patches = has_patches ? surface.patch_names.size() : 1;
  TF_CHECK(!has_patches || surface.patch_of_triangle.size() == surface.triangles.size());
  std::string text;
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

void write_surface(const SurfaceMesh& surface, const std::string& path) {
  if (path.ends_with(".off")) {
    write_file_atomically(path, write_off(surface));
  } else if (path.ends_with(".stl")) {
    write_file_atomically(path, write_stl(surface));
  } else {
    throw UsageError("unsupported type of surface file; surfaces are written as .off or .stl",
                     path);
  }
}

}  // namespace tetfarm
