#include "mesh/decompose/interdomain_mesh.h"

#include <algorithm>

#include "base/check.h"

namespace tetfarm {
namespace {

double twice_signed_area(const PlanarRegion& region) {
  double area = 0;
  for (const auto& [i, j] : region.edges) {
    const Vec2& a = region.points[idx(i)];
    const Vec2& b = region.points[idx(j)];
    area += a.x * b.y - a.y * b.x;
  }
  return area;
}

PlanarRegion project_loops(const EdgeLoops& loops, const Subdomain& subdomain,
                           InterdomainMesh& mesh) {
  PlanarRegion region;
  for (const auto& loop : loops.loops) {
    const auto first = static_cast<std::int32_t>(region.points.size());
    const auto size = static_cast<std::int32_t>(loop.size());
    for (std::int32_t i = 0; i < size; ++i) {
      const RimEdge& edge = loop[idx(i)];
      mesh.rim.push_back(edge);
      mesh.rim_vertices.push_back(edge.from);
      mesh.rim_nodes.push_back({first + i, first + (i + 1) % size});
      region.points.push_back(mesh.plane.project(subdomain.vertices[idx(edge.from)]));
      region.edges.push_back(mesh.rim_nodes.back());
    }
  }
  return region;
}

/// Surface edges with both ends on the rim that are not on it: as a chord of the cut, such an edge
/// would have four triangles.
std::vector<Chord> chords_of_surface(const InterdomainMesh& mesh, const Subdomain& subdomain,
                                     const SurfaceTopology& topology) {
  std::vector<std::int32_t> vertex2node(subdomain.vertices.size(), -1);
  for (std::size_t i = 0; i < mesh.rim_vertices.size(); ++i) {
    vertex2node[idx(mesh.rim_vertices[i])] = static_cast<std::int32_t>(i);
  }
  std::vector<Chord> chords;
  for (const std::int32_t vertex : mesh.rim_vertices) {
    for (const HalfEdge h :
         half_edges_round_start(topology, topology.vertex2half_edge[idx(vertex)])) {
      const std::int32_t end = end_of(subdomain.triangles, h);
      if (end > vertex && vertex2node[idx(end)] >= 0) {
        const auto [a, b] = std::minmax(vertex2node[idx(vertex)], vertex2node[idx(end)]);
        chords.push_back({a, b});
      }
    }
  }
  std::vector<Chord> rim = mesh.rim_nodes;
  for (auto& [a, b] : rim) {
    if (a > b) std::swap(a, b);
  }
  std::sort(rim.begin(), rim.end());
  std::sort(chords.begin(), chords.end());
  std::vector<Chord> inner;
  std::set_difference(chords.begin(), chords.end(), rim.begin(), rim.end(),
                      std::back_inserter(inner));
  return inner;
}

void find_rim_triangles(InterdomainMesh& mesh) {
  std::vector<std::array<std::int32_t, 3>> edges;  // from, to, triangle
  for (std::size_t t = 0; t < mesh.planar.triangles.size(); ++t) {
    const auto& triangle = mesh.planar.triangles[t];
    for (std::size_t k = 0; k < 3; ++k) {
      const std::int32_t a = triangle[k];
      const std::int32_t b = triangle[(k + 1) % 3];
      if (mesh.is_rim_node(a) && mesh.is_rim_node(b)) {
        edges.push_back({a, b, static_cast<std::int32_t>(t)});
      }
    }
  }
  std::sort(edges.begin(), edges.end());
  for (const auto& [from, to] : mesh.rim_nodes) {
    const auto it =
        std::lower_bound(edges.begin(), edges.end(), std::array<std::int32_t, 3>{from, to, 0});
    TF_CHECK(it != edges.end() && (*it)[0] == from && (*it)[1] == to);
    mesh.rim2triangle.push_back((*it)[2]);
  }
}

}  // namespace

InterdomainResult mesh_interdomain(const Subdomain& subdomain, const SurfaceTopology& topology,
                                   const EdgeLoops& loops, const CutPlane& plane,
                                   const SpacingField& spacing,
                                   const std::vector<Chord>& unwanted) {
  InterdomainResult result;
  InterdomainMesh& mesh = result.mesh;
  mesh.plane = plane;
  const PlanarRegion region = project_loops(loops, subdomain, mesh);
  if (!mesh.rim.empty()) {
    if (twice_signed_area(region) <= 0) return {{}, "loops enclose no region"};
    PlanarOptions options;
    options.forbidden_chords = chords_of_surface(mesh, subdomain, topology);
    options.forbidden_chords.insert(options.forbidden_chords.end(), unwanted.begin(),
                                    unwanted.end());
    PlanarResult planar = mesh_region(
        region, [&](const Vec2& p) { return spacing.at(plane.lift(p, 0)); }, options);
    if (planar.failure) return {{}, "loops tangle in the plane"};
    mesh.planar = std::move(planar.mesh);
    find_rim_triangles(mesh);
  }
  for (std::size_t i = 0; i < mesh.planar.points.size(); ++i) {
    const bool is_on_rim = i < mesh.rim_vertices.size();
    const Vec3 at = is_on_rim ? subdomain.vertices[idx(mesh.rim_vertices[i])]
                              : plane.lift(mesh.planar.points[i], 0);
    mesh.heights.push_back(is_on_rim ? plane.height(at) : 0);
    mesh.spacing.push_back(spacing.at(at));
  }
  return result;
}

std::int32_t apex_of_rim_triangle(const InterdomainMesh& mesh, std::size_t i) {
  const auto& triangle = mesh.planar.triangles[idx(mesh.rim2triangle[i])];
  for (const std::int32_t v : triangle) {
    if (v != mesh.rim_nodes[i][0] && v != mesh.rim_nodes[i][1]) return v;
  }
  return triangle[0];
}

std::vector<Chord> chords_of_triangle(const InterdomainMesh& mesh, std::int32_t triangle) {
  std::vector<Chord> chords;
  const auto& nodes = mesh.planar.triangles[idx(triangle)];
  for (std::size_t k = 0; k < 3; ++k) {
    const std::int32_t a = nodes[k];
    const std::int32_t b = nodes[(k + 1) % 3];
    if (!mesh.is_rim_node(a) || !mesh.is_rim_node(b)) continue;
    // Loops are numbered one after the other, so that the rim edge from a is number a.
    if (mesh.rim_nodes[idx(a)][1] == b) continue;
    chords.push_back({std::min(a, b), std::max(a, b)});
  }
  return chords;
}

Vec3 node_position(const InterdomainMesh& mesh, const Subdomain& subdomain, std::int32_t node) {
  if (mesh.is_rim_node(node)) return subdomain.vertices[idx(mesh.rim_vertices[idx(node)])];
  return mesh.plane.lift(mesh.planar.points[idx(node)], mesh.heights[idx(node)]);
}

}  // namespace tetfarm
