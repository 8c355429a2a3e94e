#include "mesh/half_body/plane_loops.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "base/array_index.h"
#include "base/counted.h"
#include "base/error.h"
#include "mesh/core/complaints.h"
#include "mesh/inspect/surface_edges.h"

namespace tetfarm {
namespace {

/// Of the size of the surface.
constexpr double tolerance_share = 1e-6;

using OpenEdge = std::array<std::int32_t, 2>;

[[noreturn]] void refuse(const AxisPlane& plane, const std::string& what,
                         std::vector<std::int64_t> triangles = {}) {
  throw InvalidInput(what, "symmetry " + plane.text(), std::move(triangles));
}

std::vector<OpenEdge> open_edges_of(const SurfaceMesh& surface) {
  std::vector<OpenEdge> open;
  const std::vector<EdgeUse> uses = edge_uses(surface.triangles);
  for_each_edge(uses, [&open](std::span<const EdgeUse> edge) {
    if (edge.size() == 1) open.push_back({edge.front().low, edge.front().high});
  });
  return open;
}

std::vector<std::int32_t> vertices_of(const std::vector<OpenEdge>& edges) {
  std::vector<std::int32_t> vertices;
  for (const OpenEdge& edge : edges) vertices.insert(vertices.end(), edge.begin(), edge.end());
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

/// Puts the vertices onto the plane, or the plane where all of them are.
void meet(SurfaceMesh& surface, const std::vector<std::int32_t>& vertices, double tolerance,
          PlaneLoops& found) {
  const int axis = found.plane.axis;
  const auto offset = [&](std::int32_t v) {
    return std::fabs(surface.vertices[at(v)][axis] - found.plane.height);
  };
  const auto off = [&](std::int32_t v) { return !(offset(v) <= tolerance); };
  const auto elsewhere = std::count_if(vertices.begin(), vertices.end(), off);
  if (elsewhere > 0) {
    const std::int32_t farthest =
        *std::max_element(vertices.begin(), vertices.end(),
                          [&](std::int32_t a, std::int32_t b) { return offset(a) < offset(b); });
    refuse(found.plane,
           counted(static_cast<std::uint64_t>(elsewhere), "vertex", "vertices") + " of " +
               std::to_string(vertices.size()) + " on open edges lie elsewhere, the farthest " +
               text_of(offset(farthest)) + " away at " + text_of(surface.vertices[at(farthest)]) +
               "; close the surface there, or name the plane that it ends on");
  }
  const double first = surface.vertices[at(vertices.front())][axis];
  const bool are_alike = std::all_of(vertices.begin(), vertices.end(), [&](std::int32_t v) {
    return surface.vertices[at(v)][axis] == first;
  });
  if (are_alike) {
    found.plane.height = first;
    return;
  }
  for (const std::int32_t v : vertices) {
    if (offset(v) == 0) continue;
    ++found.moved;
    found.farthest_move = std::max(found.farthest_move, offset(v));
    surface.vertices[at(v)][axis] = found.plane.height;
  }
}

/// On which side the surface is. @throws InvalidInput when it is on both.
int side_of(const SurfaceMesh& surface, const AxisPlane& plane) {
  double lowest = 0;
  double highest = 0;
  std::size_t at_lowest = 0;
  std::size_t at_highest = 0;
  for (std::size_t v = 0; v < surface.vertices.size(); ++v) {
    const double height = surface.vertices[v][plane.axis] - plane.height;
    if (height < lowest) at_lowest = v;
    if (height > highest) at_highest = v;
    lowest = std::min(lowest, height);
    highest = std::max(highest, height);
  }
  const int side = highest >= -lowest ? 1 : -1;
  const double beyond = side > 0 ? -lowest : highest;
  if (beyond > 0) {
    const std::size_t there = side > 0 ? at_lowest : at_highest;
    refuse(plane, "the surface reaches through it, by " + text_of(beyond) + " at " +
                      text_of(surface.vertices[there]) + "; cut off what lies behind it");
  }
  return side;
}

void refuse_triangles_within(const SurfaceMesh& surface, const AxisPlane& plane) {
  std::vector<std::int64_t> within;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const Triangle& corners = surface.triangles[t];
    const bool is_within = std::all_of(corners.begin(), corners.end(), [&](std::int32_t v) {
      return surface.vertices[at(v)][plane.axis] == plane.height;
    });
    if (is_within) within.push_back(static_cast<std::int64_t>(t));
  }
  if (within.empty()) return;
  refuse(plane,
         counted(within.size(), "triangle") + " of the surface " +
             (within.size() == 1 ? "lies" : "lie") + " in the plane, such as triangle " +
             std::to_string(within.front()) + " at " +
             text_of(surface.vertices[at(surface.triangles[at(within.front())][0])]) +
             "; leave them out: the plane is meshed anew",
         within);
}

/// For each vertex that has open edges, the other ends of its two.
class OpenNeighbours {
 public:
  OpenNeighbours(const SurfaceMesh& surface, const std::vector<OpenEdge>& edges,
                 const AxisPlane& plane)
      : next_(surface.vertices.size(), {none, none}) {
    for (const auto& [a, b] : edges) {
      if (add(a, b) && add(b, a)) continue;
      const std::int32_t crowded = next_[at(a)][1] != none && next_[at(a)][1] != b ? a : b;
      refuse(plane, "more than two open edges meet at " + text_of(surface.vertices[at(crowded)]) +
                        ": the loops that the surface ends in must not touch there");
    }
    for (const auto& [a, b] : edges) {
      for (const std::int32_t v : {a, b}) {
        if (next_[at(v)][1] != none) continue;
        refuse(plane, "the open edges do not go on at " + text_of(surface.vertices[at(v)]) +
                          ", where more than two triangles share an edge");
      }
    }
  }

  /// Takes the loop through v out. Empty when v has been taken out.
  std::vector<std::int32_t> take(std::int32_t v) {
    std::vector<std::int32_t> loop;
    while (next_[at(v)][0] != none) {
      const std::array<std::int32_t, 2> ends = next_[at(v)];
      const std::int32_t before = loop.empty() ? none : loop.back();
      loop.push_back(v);
      next_[at(v)] = {none, none};
      v = ends[0] == before ? ends[1] : ends[0];
    }
    return loop;
  }

 private:
  static constexpr std::int32_t none = -1;

  bool add(std::int32_t from, std::int32_t to) {
    for (std::int32_t& end : next_[at(from)]) {
      if (end != none) continue;
      end = to;
      return true;
    }
    return false;
  }

  std::vector<std::array<std::int32_t, 2>> next_;
};

std::vector<std::vector<std::int32_t>> loops_of(const SurfaceMesh& surface,
                                                const std::vector<OpenEdge>& edges,
                                                const AxisPlane& plane) {
  std::vector<std::vector<std::int32_t>> loops;
  OpenNeighbours neighbours(surface, edges, plane);
  for (const std::int32_t v : vertices_of(edges)) {
    std::vector<std::int32_t> loop = neighbours.take(v);
    if (!loop.empty()) loops.push_back(std::move(loop));
  }
  return loops;
}

}  // namespace

PlaneLoops find_plane_loops(SurfaceMesh& surface, const AxisPlane& wanted) {
  PlaneLoops found;
  found.plane = wanted;
  const std::vector<OpenEdge> edges = open_edges_of(surface);
  if (edges.empty()) {
    refuse(wanted,
           "the surface is closed, so that nothing ends on this plane; leave out the symmetry, or "
           "give one half of the surface, open where the plane is");
  }
  Box3 box;
  for (const Vec3& vertex : surface.vertices) box.add(vertex);
  const std::vector<std::int32_t> vertices = vertices_of(edges);
  meet(surface, vertices, tolerance_share * norm(box.size()), found);
  found.side = side_of(surface, found.plane);
  refuse_triangles_within(surface, found.plane);
  found.loops = loops_of(surface, edges, found.plane);
  return found;
}

std::vector<std::vector<std::int32_t>> open_loops(const SurfaceMesh& surface,
                                                  const AxisPlane& plane) {
  return loops_of(surface, open_edges_of(surface), plane);
}

}  // namespace tetfarm
