#include "mesh/volume/steiner_insertion.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "mesh/geometry/cavity_insertion.h"
#include "mesh/geometry/predicates.h"
#include "mesh/geometry/triangle_intersection.h"
#include "mesh/volume/face_recovery.h"

namespace tetfarm {
namespace {

using Edge = std::array<std::int32_t, 2>;

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

std::array<std::int32_t, 3> face_nodes(const LocalRemeshing& mesh, FaceHandle face) {
  const Tet& n = mesh.complex().nodes[at(tet_of(face))];
  const auto& f = tet_face_nodes[at(face_of(face))];
  return {n[at(f[0])], n[at(f[1])], n[at(f[2])]};
}

TrianglePoints face_points(const LocalRemeshing& mesh, FaceHandle face) {
  const auto [x, y, z] = face_nodes(mesh, face);
  return {mesh.point(x), mesh.point(y), mesh.point(z)};
}

/// Where the crossing meets the segment, as a share of its length.
double share_of_crossing(const LocalRemeshing& mesh, const Crossing& crossing, const Edge& edge) {
  const Vec3& a = mesh.point(edge[0]);
  const Vec3& b = mesh.point(edge[1]);
  double to_a = 0;
  double to_b = 0;
  if (crossing.face != no_face) {
    const auto [x, y, z] = face_points(mesh, crossing.face);
    to_a = std::abs(tet_volume(x, y, z, a));
    to_b = std::abs(tet_volume(x, y, z, b));
  } else {
    const Vec3& u = mesh.point(crossing.edge[0]);
    const Vec3& v = mesh.point(crossing.edge[1]);
    to_a = norm(cross(v - u, a - u));
    to_b = norm(cross(v - u, b - u));
  }
  if (!(to_a + to_b > 0)) return 0.5;
  return std::clamp(to_a / (to_a + to_b), 0.01, 0.99);
}

/// Where the edge uv goes through the face's plane; the centroid when it lies in it.
Vec3 place_on_face(const LocalRemeshing& mesh, const Triangle& face, const Edge& edge) {
  const Vec3& a = mesh.point(face[0]);
  const Vec3& b = mesh.point(face[1]);
  const Vec3& c = mesh.point(face[2]);
  const Vec3& u = mesh.point(edge[0]);
  const Vec3& v = mesh.point(edge[1]);
  const double above = std::abs(orient3d(a, b, c, u));
  const double below = std::abs(orient3d(a, b, c, v));
  if (!(above + below > 0)) return (a + b + c) / 3.0;
  return u + (above / (above + below)) * (v - u);
}

/// Puts the point into the complex by a constrained cavity; its number, or -1 when there is no room
/// for it.
std::int32_t insert_point(TetComplex& complex, std::vector<std::uint8_t>& constrained,
                          const Vec3& point, std::int32_t near) {
  CavityInsertion insertion(complex, &constrained);
  const Location location = insertion.locate(point, complex.node2tet[at(near)]);
  if (location.tet < 0 || location.node >= 0) return -1;
  const auto node = static_cast<std::int32_t>(complex.points.size());
  complex.points.push_back(point);
  complex.node2tet.push_back(-1);
  if (insertion.find_cavity(node, location.tet)) {
    insertion.fill();
    return node;
  }
  complex.points.pop_back();
  complex.node2tet.pop_back();
  return -1;
}

/// The tets of a crossed edge's ring, or on both sides of a crossed face; each is to be split.
std::vector<std::int32_t> tets_at(const LocalRemeshing& mesh, const Crossing& crossing) {
  if (crossing.face == no_face) {
    const auto ring = mesh.ring(crossing.edge[0], crossing.edge[1]);
    return ring ? ring->tets : std::vector<std::int32_t>{};
  }
  const std::int32_t t = tet_of(crossing.face);
  const FaceHandle other = mesh.complex().neighbours[at(t)][at(face_of(crossing.face))];
  return other == no_face ? std::vector<std::int32_t>{} : std::vector{t, tet_of(other)};
}

/// Puts the point on the crossed edge or face by splitting what lies round it; -1 when a part would
/// not be positive or a constrained face is in the way.
std::int32_t split_crossing(TetComplex& complex, std::vector<std::uint8_t>& constrained,
                            const Crossing& crossing, const Vec3& point) {
  LocalRemeshing mesh(complex, constrained);
  const auto old_tets = tets_at(mesh, crossing);
  std::array<std::int32_t, 3> crossed = {crossing.edge[0], crossing.edge[1], -1};
  if (crossing.face != no_face) crossed = face_nodes(mesh, crossing.face);
  const std::int32_t node = mesh.add_point(point);
  std::vector<Tet> parts;
  bool is_good = !old_tets.empty();
  for (const std::int32_t t : old_tets) {
    const Tet& n = complex.nodes[at(t)];
    for (int i = 0; i < 4; ++i) {
      // The point takes the place of a node of what is crossed, each in turn.
      const std::int32_t v = n[at(i)];
      if (std::find(crossed.begin(), crossed.end(), v) == crossed.end()) continue;
      Tet part = n;
      part[at(i)] = node;
      const auto p = [&](std::size_t k) { return mesh.point(part[k]); };
      is_good = is_good && orient3d(p(0), p(1), p(2), p(3)) > 0;
      parts.push_back(part);
    }
    for (int i = 0; i < 4; ++i) {
      const bool joins_old = std::find(crossed.begin(), crossed.end(), n[at(i)]) == crossed.end();
      if (!joins_old) continue;
      const FaceHandle here = face_handle(t, i);
      const FaceHandle other = complex.neighbours[at(t)][at(i)];
      const bool is_between = other != no_face && std::find(old_tets.begin(), old_tets.end(),
                                                            tet_of(other)) != old_tets.end();
      if (is_between && mesh.is_constrained(here)) is_good = false;
    }
  }
  if (is_good) {
    mesh.replace(old_tets, parts);
    mesh.forget_journal();
    return node;
  }
  mesh.roll_back(0);
  return -1;
}

}  // namespace

std::int32_t insert_on_edge(TetComplex& complex, std::vector<std::uint8_t>& constrained,
                            const Edge& edge, const SegmentWalk& walk) {
  const std::size_t n = walk.crossings.size();
  const Vec3 a = complex.points[at(edge[0])];
  const Vec3 b = complex.points[at(edge[1])];
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t i = (n / 2 + k) % n;
    double share = 0.5;
    {
      const LocalRemeshing mesh(complex, constrained);
      share = share_of_crossing(mesh, walk.crossings[i], edge);
    }
    const Vec3 place = a + share * (b - a);
    std::int32_t node = split_crossing(complex, constrained, walk.crossings[i], place);
    if (node < 0) node = insert_point(complex, constrained, place, edge[0]);
    if (node >= 0) return node;
  }
  return -1;
}

std::int32_t insert_on_face(TetComplex& complex, std::vector<std::uint8_t>& constrained,
                            const Triangle& face) {
  std::vector<Edge> edges;
  std::vector<Vec3> places;
  {
    const LocalRemeshing mesh(complex, constrained);
    edges = piercing_edges(mesh, face);
    for (const Edge& edge : edges) places.push_back(place_on_face(mesh, face, edge));
  }
  const auto p = [&complex](std::int32_t v) { return complex.points[at(v)]; };
  const Vec3 centroid = (p(face[0]) + p(face[1]) + p(face[2])) / 3.0;
  std::vector<std::size_t> order(edges.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
    return distance(places[i], centroid) < distance(places[j], centroid);
  });
  for (const std::size_t i : order) {
    const Crossing crossing{no_face, edges[i]};
    const std::int32_t node = split_crossing(complex, constrained, crossing, places[i]);
    if (node >= 0) return node;
  }
  return insert_point(complex, constrained, centroid, face[0]);
}

}  // namespace tetfarm
