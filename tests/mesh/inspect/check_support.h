/// Shapes and questions that the tests of the surface check share.
#pragma once

#include <algorithm>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "mesh/core/surface_mesh.h"
#include "mesh/inspect/surface_check.h"

namespace tetfarm {

/// Both surfaces in one mesh, each as it is.
inline SurfaceMesh joined(const SurfaceMesh& a, const SurfaceMesh& b) {
  SurfaceMesh mesh = a;
  const auto offset = static_cast<std::int32_t>(a.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), b.vertices.begin(), b.vertices.end());
  for (const auto& [i, j, k] : b.triangles) {
    mesh.triangles.push_back({i + offset, j + offset, k + offset});
  }
  mesh.patch_of_triangle.assign(mesh.triangles.size(), 0);
  mesh.patch_names = {"surface"};
  return mesh;
}

/// Vertices at equal places become the first of them.
inline SurfaceMesh welded(SurfaceMesh mesh) {
  for (Triangle& t : mesh.triangles) {
    for (std::int32_t& v : t) {
      const auto first =
          std::ranges::find(mesh.vertices, mesh.vertices[static_cast<std::size_t>(v)]);
      v = static_cast<std::int32_t>(first - mesh.vertices.begin());
    }
  }
  return mesh;
}

inline std::vector<std::string> kinds(const SurfaceReport& report) {
  std::vector<std::string> result;
  for (const SurfaceDefect& defect : report.defects) result.push_back(defect.kind);
  return result;
}

inline std::vector<std::string> kinds_of(const SurfaceMesh& surface) {
  return kinds(check_surface(surface).report);
}

/// A whole number in [0, n), the same on every machine.
inline std::size_t below(std::mt19937& random, std::size_t n) { return random() % n; }

}  // namespace tetfarm
