#include "mesh/assemble/forced_nodes.h"

#include <algorithm>
#include <utility>

#include "base/array_index.h"
#include "base/check.h"
#include "mesh/assemble/forced_dihedral.h"
#include "mesh/core/tet_quality.h"
#include "mesh/core/triangle_angles.h"

namespace tetfarm {
namespace {

/// Those that bound the region and have a wanted vertex, turned to point out of it.
std::vector<Triangle> triangles_that_count(const SurfaceMesh& surface, std::int32_t region,
                                           const std::vector<bool>& is_wanted) {
  std::vector<Triangle> result;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const Sides sides = sides_of(surface, t);
    if (sides[0] != region && sides[1] != region) continue;
    Triangle nodes = surface.triangles[t];
    const auto counts = [&is_wanted](std::int32_t v) { return is_wanted[at(v)]; };
    if (std::none_of(nodes.begin(), nodes.end(), counts)) continue;
    if (sides[0] != region) std::swap(nodes[1], nodes[2]);
    result.push_back(nodes);
  }
  return result;
}

constexpr std::int32_t not_here = -1;

/// Of each vertex of the surface its node in the part, as the global numbers tell.
std::vector<std::int32_t> surface2local(const NumberedPart& part, const SurfaceMesh& surface,
                                        const Numbering& numbering) {
  std::vector<std::int32_t> rank2local(at(numbering.surface_nodes), not_here);
  TF_CHECK(numbering.surface_nodes + std::ssize(numbering.unused_vertices) ==
           std::ssize(surface.vertices));
  for (std::size_t v = 0; v < part.local2global.size(); ++v) {
    const std::int64_t number = part.local2global[v];
    if (number < numbering.surface_nodes) rank2local[at(number)] = static_cast<std::int32_t>(v);
  }
  std::vector<std::int32_t> result(surface.vertices.size(), not_here);
  auto unused = numbering.unused_vertices.begin();
  std::size_t rank = 0;
  for (std::size_t v = 0; v < result.size() && rank < rank2local.size(); ++v) {
    if (unused != numbering.unused_vertices.end() && at(*unused) == v) {
      ++unused;
    } else {
      result[v] = rank2local[rank++];
    }
  }
  return result;
}

/// Of each node of the part.
std::vector<bool> forced_nodes_of(const NumberedPart& part, const SurfaceMesh& surface,
                                  const Numbering& numbering) {
  const std::vector<std::int32_t> local = surface2local(part, surface, numbering);
  std::vector<bool> is_here;
  is_here.reserve(local.size());
  for (const std::int32_t v : local) is_here.push_back(v != not_here);
  const std::vector<bool> of_surface = forced_nodes(surface, part.region, is_here);
  std::vector<bool> is_forced(part.nodes.size(), false);
  for (std::size_t v = 0; v < of_surface.size(); ++v) {
    if (of_surface[v]) {
      TF_CHECK(local[v] != not_here);
      is_forced[at(local[v])] = true;
    }
  }
  return is_forced;
}

}  // namespace

std::vector<bool> forced_nodes(const SurfaceMesh& surface, std::int32_t region,
                               const std::vector<bool>& is_wanted) {
  TF_CHECK(is_wanted.size() == surface.vertices.size());
  const std::vector<Triangle> triangles = triangles_that_count(surface, region, is_wanted);
  const auto place = [&surface](std::int32_t v) -> const Vec3& { return surface.vertices[at(v)]; };
  std::vector<bool> is_forced(surface.vertices.size(), false);
  const auto force = [&](std::int32_t v) { is_forced[at(v)] = is_wanted[at(v)]; };
  for (const auto& [a, b, c] : triangles) {
    if (smallest_angle_deg(place(a), place(b), place(c)) >= forcing_deg) continue;
    for (const std::int32_t v : {a, b, c}) force(v);
  }
  for_each_edge_of_two(triangles, [&](const EdgeOfTwo& edge) {
    const double bound =
        forced_dihedral_at_edge(place(edge.u), place(edge.v), place(edge.left), place(edge.right));
    if (bound >= forcing_deg) return;
    force(edge.u);
    force(edge.v);
  });
  return is_forced;
}

UnforcedTets unforced_tets(const Portion& portion, const SurfaceMesh& surface,
                           const Numbering& numbering) {
  const std::vector<bool> is_forced = forced_nodes_of(portion.part, surface, numbering);
  TF_CHECK(std::ssize(portion.part.tets) == portion.tets);
  const ShapeStatistics& all = portion.shapes.all;
  if (std::find(is_forced.begin(), is_forced.end(), true) == is_forced.end()) {
    return {all.tets, all.min_dihedral_deg, all.worst_centroid};
  }
  const auto node = [&portion](std::int32_t v) -> const Vec3& { return portion.part.nodes[at(v)]; };
  const auto forced = [&is_forced](std::int32_t v) { return is_forced[at(v)]; };
  UnforcedTets result;
  for (const Tet& tet : portion.part.tets) {
    if (std::any_of(tet.begin(), tet.end(), forced)) continue;
    ++result.tets;
    const auto& [a, b, c, d] = tet;
    const double angle = dihedral_range(node(a), node(b), node(c), node(d)).min_deg;
    if (angle >= result.min_dihedral_deg) continue;
    result.min_dihedral_deg = angle;
    result.worst_centroid = 0.25 * (node(a) + node(b) + node(c) + node(d));
  }
  return result;
}

}  // namespace tetfarm
