#include "mesh/layers/pml_inset.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "base/array_index.h"
#include "base/error.h"
#include "mesh/core/complaints.h"
#include "mesh/layers/pml_offset.h"
#include "mesh/layers/wall_shells.h"

namespace tetfarm {
namespace {

/// The space between two parallel planes.
struct Slab {
  Vec3 normal;
  double low = 0;  ///< along the normal
  double high = 0;
};

using Slabs = std::array<Slab, 3>;

bool are_parallel(const Vec3& a, const Vec3& b) { return norm(cross(a, b)) < same_plane_sine; }

/// The first of up to three directions that faces of the shell look along or against; nothing of a
/// shell with more.
std::optional<std::vector<Vec3>> three_normals(const SurfaceMesh& surface,
                                               const ClosedShell& shell) {
  std::vector<Vec3> found;
  for (const Triangle& t : shell.triangles) {
    const Vec3 normal = outward_normal(surface, t);
    const bool is_known = std::any_of(
        found.begin(), found.end(), [&](const Vec3& other) { return are_parallel(other, normal); });
    if (is_known) continue;
    if (found.size() == 3) return std::nullopt;
    found.push_back(normal);
  }
  return found;
}

bool lies_on_a_side(const SurfaceMesh& surface, const Triangle& t, const Slabs& slabs) {
  const Vec3 normal = outward_normal(surface, t);
  return std::any_of(slabs.begin(), slabs.end(), [&](const Slab& slab) {
    if (!are_parallel(slab.normal, normal)) return false;
    const double side = dot(slab.normal, normal) > 0 ? slab.high : slab.low;
    const double tolerance = same_plane_sine * (slab.high - slab.low);
    return std::all_of(t.begin(), t.end(), [&](std::int32_t v) {
      return std::abs(dot(slab.normal, surface.vertices[at(v)]) - side) <= tolerance;
    });
  });
}

/// Of a shell that is a box, straight or skew, the pairs of planes that it lies between.
std::optional<Slabs> slabs_of(const SurfaceMesh& surface, const ClosedShell& shell) {
  const std::optional<std::vector<Vec3>> normals = three_normals(surface, shell);
  if (!normals || normals->size() < 3) return std::nullopt;
  Slabs slabs;
  for (std::size_t i = 0; i < 3; ++i) {
    slabs[i].normal = (*normals)[i];
    slabs[i].low = slabs[i].high = dot(slabs[i].normal, surface.vertices[at(shell.vertices[0])]);
    for (const std::int32_t v : shell.vertices) {
      const double along = dot(slabs[i].normal, surface.vertices[at(v)]);
      slabs[i].low = std::min(slabs[i].low, along);
      slabs[i].high = std::max(slabs[i].high, along);
    }
  }
  const bool is_box =
      std::all_of(shell.triangles.begin(), shell.triangles.end(),
                  [&](const Triangle& t) { return lies_on_a_side(surface, t, slabs); });
  return is_box ? std::optional(slabs) : std::nullopt;
}

/// By 1 on each plane, against the normal on the higher and along it on the lower, and in
/// proportion between them.
Vec3 way_to_the_middle(const Slabs& slabs, const Vec3& p) {
  const Vec3& a = slabs[0].normal;
  const Vec3& b = slabs[1].normal;
  const Vec3& c = slabs[2].normal;
  const std::array<Vec3, 3> edges = {cross(b, c), cross(c, a), cross(a, b)};
  Vec3 way;
  for (std::size_t i = 0; i < 3; ++i) {
    const Slab& slab = slabs[i];
    const double share = (slab.low + slab.high - 2 * dot(slab.normal, p)) / (slab.high - slab.low);
    way += share / dot(slab.normal, edges[i]) * edges[i];
  }
  return way;
}

/// Whatever its shape, a shell has no more room than half its width along an axis.
void require_width(const SurfaceMesh& surface, const ClosedShell& shell, double thickness) {
  Box3 box;
  for (const std::int32_t v : shell.vertices) box.add(surface.vertices[at(v)]);
  for (const int axis : {0, 1, 2}) {
    const double width = box.high[axis] - box.low[axis];
    if (2 * thickness < width) continue;
    throw UsageError("inside, they would be " + text_of(thickness) +
                         " thick together, and the outer boundary is only " + text_of(width) +
                         " wide along " + "xyz"[axis] +
                         "; give fewer or lower layers, or a larger boundary",
                     "absorbing layers");
  }
}

}  // namespace

std::vector<Vec3> pml_ways_inwards(const SurfaceMesh& surface,
                                   std::span<const std::int32_t> patches, double thickness) {
  std::vector<Vec3> ways = pml_directions(surface, patches);
  for (Vec3& way : ways) way = -way;
  for (const ClosedShell& shell : shells_of(surface, graph_of_whole_shells(surface, patches))) {
    require_width(surface, shell, thickness);
    const std::optional<Slabs> slabs = slabs_of(surface, shell);
    if (!slabs) continue;
    for (const std::int32_t v : shell.vertices) {
      ways[at(v)] = way_to_the_middle(*slabs, surface.vertices[at(v)]);
    }
  }
  return ways;
}

}  // namespace tetfarm
