#include "mesh/inspect/shell_nesting.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"
#include "mesh/geometry/box_tree.h"
#include "mesh/inspect/shifted_ray.h"

namespace tetfarm {
namespace {

/// The shell that alone uses a vertex; -1: none does, -2: several do.
std::vector<std::int32_t> owners_of_vertices(const SurfaceMesh& surface,
                                             const std::vector<std::vector<std::int32_t>>& shells) {
  std::vector<std::int32_t> owner(surface.vertices.size(), -1);
  for (std::size_t s = 0; s < shells.size(); ++s) {
    const auto shell = static_cast<std::int32_t>(s);
    for (const std::int32_t t : shells[s]) {
      for (const std::int32_t v : surface.triangles[static_cast<std::size_t>(t)]) {
        std::int32_t& o = owner[static_cast<std::size_t>(v)];
        o = o == -1 || o == shell ? shell : -2;
      }
    }
  }
  return owner;
}

Vec3 start_of_ray(const SurfaceMesh& surface, const std::vector<std::int32_t>& shell,
                  std::int32_t number, const std::vector<std::int32_t>& owner) {
  TF_CHECK(!shell.empty());
  for (const std::int32_t t : shell) {
    for (const std::int32_t v : surface.triangles[static_cast<std::size_t>(t)]) {
      const auto i = static_cast<std::size_t>(v);
      if (owner[i] == number) return surface.vertices[i];
    }
  }
  const TrianglePoints first =
      triangle_points(surface.vertices, surface.triangles[static_cast<std::size_t>(shell[0])]);
  return (first[0] + first[1] + first[2]) / 3;
}

/// Those that occur an odd number of times, sorted.
std::vector<std::int32_t> odd_ones(std::vector<std::int32_t> numbers) {
  std::ranges::sort(numbers);
  std::vector<std::int32_t> odd;
  for (const std::int32_t i : numbers) {
    if (!odd.empty() && odd.back() == i) {
      odd.pop_back();
    } else {
      odd.push_back(i);
    }
  }
  return odd;
}

}  // namespace

std::vector<ShellPlace> nest_shells(const SurfaceMesh& surface,
                                    const std::vector<std::vector<std::int32_t>>& shells) {
  std::vector<ShellPlace> places(shells.size());
  if (shells.size() < 2) return places;
  std::vector<Triangle> triangles;
  std::vector<std::int32_t> triangle2shell;
  for (std::size_t s = 0; s < shells.size(); ++s) {
    for (const std::int32_t t : shells[s]) {
      triangles.push_back(surface.triangles[static_cast<std::size_t>(t)]);
      triangle2shell.push_back(static_cast<std::int32_t>(s));
    }
  }
  const BoxTree tree(triangle_boxes(surface.vertices, triangles));
  const auto owner = owners_of_vertices(surface, shells);
  std::vector<std::vector<std::int32_t>> containers(shells.size());
  for (std::size_t s = 0; s < shells.size(); ++s) {
    const auto number = static_cast<std::int32_t>(s);
    const Vec3 p = start_of_ray(surface, shells[s], number, owner);
    std::vector<std::int32_t> left;
    tree.query({p, {HUGE_VAL, p.y, p.z}}, [&](std::int32_t i) {
      const auto t = static_cast<std::size_t>(i);
      if (triangle2shell[t] == number) return;
      if (ray_passes(p, triangle_points(surface.vertices, triangles[t])) != 0) {
        left.push_back(triangle2shell[t]);
      }
    });
    containers[s] = odd_ones(std::move(left));
    places[s].depth = static_cast<int>(containers[s].size());
  }
  for (std::size_t s = 0; s < shells.size(); ++s) {
    for (const std::int32_t c : containers[s]) {
      if (places[static_cast<std::size_t>(c)].depth == places[s].depth - 1) places[s].parent = c;
    }
  }
  return places;
}

}  // namespace tetfarm
