#include "mesh/decompose/interdomain_mesh.h"

#include <algorithm>

#include "base/array_index.h"
#include "base/check.h"
#include "mesh/geometry/box_tree.h"
#include "mesh/spacing/octree_build.h"

namespace tetfarm {
namespace {

double twice_signed_area(const PlanarRegion& region) {
  double area = 0;
  for (const auto& [i, j] : region.edges) {
    const Vec2& a = region.points[at(i)];
    const Vec2& b = region.points[at(j)];
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
      const RimEdge& edge = loop[at(i)];
      mesh.rim.push_back(edge);
      mesh.rim_vertices.push_back(edge.from);
      mesh.rim_nodes.push_back({first + i, first + (i + 1) % size});
      region.points.push_back(mesh.plane.project(subdomain.vertices[at(edge.from)]));
      region.edges.push_back(mesh.rim_nodes.back());
    }
  }
  TF_CHECK(mesh.rim.size() == mesh.rim_vertices.size() && mesh.rim.size() == region.points.size());
  return region;
}

/// Surface edges with both ends on the rim that are not on it: as a chord of the cut, such an edge
/// would have four triangles.
std::vector<Chord> chords_of_surface(const InterdomainMesh& mesh, const Subdomain& subdomain,
                                     const SurfaceTopology& topology) {
  std::vector<std::int32_t> vertex2node(subdomain.vertices.size(), -1);
  for (std::size_t i = 0; i < mesh.rim_vertices.size(); ++i) {
    vertex2node[at(mesh.rim_vertices[i])] = static_cast<std::int32_t>(i);
  }
  std::vector<Chord> chords;
  for (const std::int32_t vertex : mesh.rim_vertices) {
    for (const HalfEdge h :
         half_edges_round_start(topology, topology.vertex2half_edge[at(vertex)])) {
      const std::int32_t end = end_of(subdomain.triangles, h);
      if (end > vertex && vertex2node[at(end)] >= 0) {
        const auto [a, b] = std::minmax(vertex2node[at(vertex)], vertex2node[at(end)]);
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
  TF_CHECK(mesh.rim2triangle.size() == mesh.rim_nodes.size());
}

double squared_distance(const Vec2& p, const Vec2& a, const Vec2& b) {
  const Vec2 ab{b.x - a.x, b.y - a.y};
  const Vec2 ap{p.x - a.x, p.y - a.y};
  const double length2 = ab.x * ab.x + ab.y * ab.y;
  const double t = length2 > 0 ? std::clamp((ap.x * ab.x + ap.y * ab.y) / length2, 0.0, 1.0) : 0.0;
  const Vec2 away{ap.x - t * ab.x, ap.y - t * ab.y};
  return away.x * away.x + away.y * away.y;
}

/// Near the rim the cut leaves the plane and has nodes of its own.
std::vector<LatticeNodeOfCut> nodes_clear_of_rim(const std::vector<LatticeNode>& nodes,
                                                 const InterdomainMesh& mesh,
                                                 const PlanarRegion& region) {
  constexpr double least_distance = 0.65;  // in the mean edges of the lattice's tets
  constexpr double held_from = 1.5;
  if (nodes.empty()) return {};
  std::vector<Box3> boxes;
  for (const auto& [i, j] : region.edges) {
    Box3 box;
    box.add(Vec3{region.points[at(i)].x, region.points[at(i)].y, 0});
    box.add(Vec3{region.points[at(j)].x, region.points[at(j)].y, 0});
    boxes.push_back(box);
  }
  const BoxTree tree(boxes);
  std::vector<LatticeNodeOfCut> clear;
  for (const LatticeNode& node : nodes) {
    const Vec2 p = mesh.plane.project(node.place());
    const double h = lattice_ratio * node.cell_edge;
    const double reach = held_from * h;
    double nearest2 = reach * reach;
    tree.query({{p.x - reach, p.y - reach, 0}, {p.x + reach, p.y + reach, 0}}, [&](std::int32_t e) {
      const auto& [i, j] = region.edges[at(e)];
      nearest2 =
          std::min(nearest2, squared_distance(p, region.points[at(i)], region.points[at(j)]));
    });
    if (nearest2 < least_distance * least_distance * h * h) continue;
    clear.push_back({node.place(), nearest2 >= reach * reach});
  }
  return clear;
}

/// Where the lattice gives the nodes, its cells may be larger than the spacing: no more are wanted.
PlanarSpacing planar_spacing(const InterdomainMesh& mesh, const SpacingField& spacing) {
  return [&mesh, &spacing](const Vec2& p) {
    const Vec3 at = mesh.plane.lift(p, 0);
    const double h = spacing.at(at);
    return mesh.lattice.empty() ? h : std::max(h, lattice_ratio * spacing.lattice_cell_edge(at));
  };
}

/// Lattice nodes that are in no triangle lie outside of the region.
void drop_lattice_outside(InterdomainMesh& mesh) {
  if (mesh.lattice.empty()) return;
  std::vector<std::int32_t> old2new(mesh.planar.points.size(), -1);
  for (const auto& triangle : mesh.planar.triangles) {
    for (const std::int32_t v : triangle) old2new[at(v)] = 0;
  }
  std::vector<Vec2> points;
  std::vector<LatticeNodeOfCut> lattice;
  for (std::size_t i = 0; i < old2new.size(); ++i) {
    const bool is_of_lattice =
        i >= mesh.rim_vertices.size() && i < mesh.rim_vertices.size() + mesh.lattice.size();
    if (is_of_lattice) {
      if (old2new[i] < 0) continue;
      lattice.push_back(mesh.lattice[i - mesh.rim_vertices.size()]);
    }
    old2new[i] = static_cast<std::int32_t>(points.size());
    points.push_back(mesh.planar.points[i]);
  }
  for (auto& triangle : mesh.planar.triangles) {
    for (std::int32_t& v : triangle) v = old2new[at(v)];
  }
  mesh.planar.points = std::move(points);
  mesh.lattice = std::move(lattice);
  TF_CHECK(mesh.planar.points.size() >= mesh.rim_vertices.size());
}

}  // namespace

InterdomainResult mesh_interdomain(const Subdomain& subdomain, const SurfaceTopology& topology,
                                   const EdgeLoops& loops, const CutPlane& plane,
                                   const SpacingField& spacing, const InnerNodes& inner) {
  InterdomainResult result;
  InterdomainMesh& mesh = result.mesh;
  mesh.plane = plane;
  PlanarRegion region = project_loops(loops, subdomain, mesh);
  if (!mesh.rim.empty()) {
    if (twice_signed_area(region) <= 0) return {{}, "loops enclose no region"};
    mesh.lattice = nodes_clear_of_rim(inner.lattice, mesh, region);
    for (const LatticeNodeOfCut& node : mesh.lattice) {
      region.points.push_back(plane.project(node.at));
    }
    PlanarOptions options;
    options.forbidden_chords = chords_of_surface(mesh, subdomain, topology);
    options.forbidden_chords.insert(options.forbidden_chords.end(), inner.unwanted_chords.begin(),
                                    inner.unwanted_chords.end());
    PlanarResult planar = mesh_region(region, planar_spacing(mesh, spacing), options);
    if (planar.failure) return {{}, "loops tangle in the plane"};
    mesh.planar = std::move(planar.mesh);
    drop_lattice_outside(mesh);
    find_rim_triangles(mesh);
  }
  for (std::size_t i = 0; i < mesh.planar.points.size(); ++i) {
    const bool is_on_rim = i < mesh.rim_vertices.size();
    const Vec3 place = is_on_rim ? subdomain.vertices[at(mesh.rim_vertices[i])]
                                 : plane.lift(mesh.planar.points[i], 0);
    mesh.heights.push_back(is_on_rim ? plane.height(place) : 0);
    mesh.spacing.push_back(spacing.at(place));
  }
  TF_CHECK(mesh.heights.size() == mesh.planar.points.size());
  return result;
}

std::int32_t apex_of_rim_triangle(const InterdomainMesh& mesh, std::size_t i) {
  const auto& triangle = mesh.planar.triangles[at(mesh.rim2triangle[i])];
  for (const std::int32_t v : triangle) {
    if (v != mesh.rim_nodes[i][0] && v != mesh.rim_nodes[i][1]) return v;
  }
  // A triangle has a third node.
  check_failed("the rim's triangle has only its edge", __FILE__, __LINE__);
}

std::vector<Chord> chords_of_triangle(const InterdomainMesh& mesh, std::int32_t triangle) {
  std::vector<Chord> chords;
  const auto& nodes = mesh.planar.triangles[at(triangle)];
  for (std::size_t k = 0; k < 3; ++k) {
    const std::int32_t a = nodes[k];
    const std::int32_t b = nodes[(k + 1) % 3];
    if (!mesh.is_rim_node(a) || !mesh.is_rim_node(b)) continue;
    // Loops are numbered one after the other, so that the rim edge from a is number a.
    if (mesh.rim_nodes[at(a)][1] == b) continue;
    chords.push_back({std::min(a, b), std::max(a, b)});
  }
  return chords;
}

Vec3 node_position(const InterdomainMesh& mesh, const Subdomain& subdomain, std::int32_t node) {
  if (mesh.is_rim_node(node)) return subdomain.vertices[at(mesh.rim_vertices[at(node)])];
  const std::size_t number = at(node) - mesh.rim_vertices.size();
  if (number < mesh.lattice.size()) {
    const Vec3& place = mesh.lattice[number].at;
    if (mesh.heights[at(node)] == mesh.plane.height(place)) return place;
  }
  return mesh.plane.lift(mesh.planar.points[at(node)], mesh.heights[at(node)]);
}

}  // namespace tetfarm
