// Surfaces with one kind of damage, and what healing steps work on.
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/healing/heal_surface.h"
#include "tests/support/shapes.h"

namespace tetfarm::test {

/// A surface, and the work on it with a tolerance of 1e-6 and any hole and move.
struct Damaged {
  explicit Damaged(SurfaceMesh given) : surface(std::move(given)) {}

  SurfaceMesh surface;
  std::vector<HealAct> acts = {};
  HealingWork work{surface, 1e-6, 1e9, 1e9, acts};
};

inline std::vector<SurfaceDefect> defects_of(const SurfaceMesh& surface) {
  return check_surface(surface).report.defects;
}

inline std::vector<char> all_of(const SurfaceMesh& surface) {
  return std::vector<char>(surface.triangles.size(), 1);
}

/// Both in one surface, of the first one's patch.
inline SurfaceMesh with_body(SurfaceMesh surface, const SurfaceMesh& body) {
  const auto first = static_cast<std::int32_t>(surface.vertices.size());
  surface.vertices.insert(surface.vertices.end(), body.vertices.begin(), body.vertices.end());
  for (const Triangle& t : body.triangles) {
    add_triangle(surface, {first + t[0], first + t[1], first + t[2]}, 0);
  }
  return surface;
}

/// A copy of a triangle with the same patch.
inline void add_copy(SurfaceMesh& surface, std::size_t t, const Triangle& nodes) {
  add_triangle(surface, nodes, patch_of(surface, t));
}

inline void remove_triangle(SurfaceMesh& surface, std::size_t t) {
  std::vector<char> is_gone(surface.triangles.size(), 0);
  is_gone[t] = 1;
  remove_triangles(surface, is_gone);
}

/// Triangle t no longer shares its first vertex: it has one of its own, `off` away.
inline void tear(SurfaceMesh& surface, std::size_t t, const Vec3& off) {
  std::int32_t& corner = surface.triangles[t][0];
  const Vec3 at = surface.vertices[static_cast<std::size_t>(corner)] + off;
  corner = static_cast<std::int32_t>(surface.vertices.size());
  surface.vertices.push_back(at);
}

/// Triangle t is divided at the middle of its first edge; the one beyond is not.
inline void divide_one_side(SurfaceMesh& surface, std::size_t t) {
  const Triangle n = surface.triangles[t];
  const Vec3& a = surface.vertices[static_cast<std::size_t>(n[0])];
  const Vec3& b = surface.vertices[static_cast<std::size_t>(n[1])];
  const Vec3 middle = 0.5 * (a + b);
  const auto m = static_cast<std::int32_t>(surface.vertices.size());
  surface.vertices.push_back(middle);
  surface.triangles[t] = {n[0], m, n[2]};
  add_copy(surface, t, {m, n[1], n[2]});
}

/// The same, and a triangle without area fills the seam.
inline void add_flat_triangle(SurfaceMesh& surface, std::size_t t) {
  const Triangle n = surface.triangles[t];
  divide_one_side(surface, t);
  const auto m = static_cast<std::int32_t>(surface.vertices.size()) - 1;
  add_copy(surface, t, {n[0], n[1], m});
}

}  // namespace tetfarm::test
