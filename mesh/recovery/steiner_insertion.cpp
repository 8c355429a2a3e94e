#include "mesh/recovery/steiner_insertion.h"

#include <algorithm>
#include <numeric>
#include <span>

#include "base/array_index.h"
#include "base/check.h"
#include "mesh/recovery/face_recovery.h"

namespace tetfarm {
namespace {

using Edge = std::array<std::int32_t, 2>;

constexpr DoubleDouble one_half = {0.5, 0};

std::array<std::int32_t, 3> face_nodes(const LocalRemeshing& mesh, FaceHandle face) {
  const Tet& n = mesh.complex().nodes[at(tet_of(face))];
  const auto& f = tet_face_nodes[at(face_of(face))];
  return {n[at(f[0])], n[at(f[1])], n[at(f[2])]};
}

/// A place on the missing edge or face.
struct Place {
  std::span<const std::int32_t> corners;
  FinePoint point;
};

/// p / (p + q) of two sizes.
DoubleDouble share_of(const DoubleDouble& p, const DoubleDouble& q) {
  const DoubleDouble sum = magnitude(p) + magnitude(q);
  return sum.high > 0 ? magnitude(p) / sum : one_half;
}

/// Where the plane of the triangle meets the segment, as a share of its length.
DoubleDouble share_at_plane(const LocalRemeshing& mesh, const Triangle& triangle,
                            const Edge& segment) {
  const FinePoint x = mesh.fine_point(triangle[0]), y = mesh.fine_point(triangle[1]),
                  z = mesh.fine_point(triangle[2]);
  return share_of(fine_orient3d(x, y, z, mesh.fine_point(segment[0])),
                  fine_orient3d(x, y, z, mesh.fine_point(segment[1])));
}

/// Where the edge uv, in one plane with the segment, crosses it.
DoubleDouble share_at_edge(const LocalRemeshing& mesh, const Edge& edge, const Edge& segment) {
  const FinePoint u = mesh.fine_point(edge[0]), v = mesh.fine_point(edge[1]);
  const FinePoint a = mesh.fine_point(segment[0]), b = mesh.fine_point(segment[1]);
  const FineVec3 along = difference(u, v);
  const FineVec3 normal = cross(along, difference(a, b));
  return share_of(dot(cross(along, difference(u, a)), normal),
                  dot(cross(along, difference(u, b)), normal));
}

DoubleDouble share_of_crossing(const LocalRemeshing& mesh, const Crossing& crossing,
                               const Edge& segment) {
  if (crossing.face == no_face) return share_at_edge(mesh, crossing.edge, segment);
  return share_at_plane(mesh, face_nodes(mesh, crossing.face), segment);
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

/// Whether a constrained face lies between two of the tets.
bool has_constraint_between(const LocalRemeshing& mesh, const std::vector<std::int32_t>& tets) {
  for (const std::int32_t t : tets) {
    for (int i = 0; i < 4; ++i) {
      const FaceHandle here = face_handle(t, i);
      const FaceHandle other = mesh.complex().neighbours[at(t)][at(i)];
      if (other == no_face || !mesh.is_constrained(here)) continue;
      if (std::find(tets.begin(), tets.end(), tet_of(other)) != tets.end()) return true;
    }
  }
  return false;
}

/// Puts the point into the tets: it takes the place of each of the nodes `replaced`, in turn. -1
/// when a part would not be positive or a constrained face is in the way.
std::int32_t split_tets(LocalRemeshing& mesh, const std::vector<std::int32_t>& tets,
                        std::span<const std::int32_t> replaced, const Place& place) {
  if (tets.empty() || has_constraint_between(mesh, tets)) return -1;
  const std::size_t mark = mesh.mark();
  const std::int32_t node = mesh.add_point_on(place.corners, place.point);
  std::vector<Tet> parts;
  bool is_good = true;
  for (const std::int32_t t : tets) {
    const Tet n = mesh.complex().nodes[at(t)];
    for (std::size_t i = 0; i < 4; ++i) {
      if (std::find(replaced.begin(), replaced.end(), n[i]) == replaced.end()) continue;
      Tet part = n;
      part[i] = node;
      is_good = is_good && mesh.orient(part[0], part[1], part[2], part[3]) > 0;
      parts.push_back(part);
    }
  }
  if (is_good) {
    mesh.replace(tets, parts);
    mesh.forget_journal();
    return node;
  }
  mesh.roll_back(mark);
  return -1;
}

/// On the crossed face; else on an edge of it, which the point may be too near to.
std::int32_t split_crossing(LocalRemeshing& mesh, const RecoverySurface& surface,
                            const Crossing& crossing, const Place& place) {
  if (crossing.face == no_face) {
    return split_tets(mesh, tets_at(mesh, crossing), crossing.edge, place);
  }
  const auto corners = face_nodes(mesh, crossing.face);
  const std::int32_t node = split_tets(mesh, tets_at(mesh, crossing), corners, place);
  if (node >= 0) return node;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::int32_t u = corners[k], v = corners[(k + 1) % 3];
    // Nodes that the surface does not know are on parts of it.
    if (std::max(u, v) >= surface.nodes() || surface.has_edge(u, v)) continue;
    const Crossing edge{no_face, {u, v}};
    const std::int32_t on_edge = split_tets(mesh, tets_at(mesh, edge), edge.edge, place);
    if (on_edge >= 0) return on_edge;
  }
  return -1;
}

std::int32_t split_tet(LocalRemeshing& mesh, std::int32_t tet, const Place& place) {
  const Tet n = mesh.complex().nodes[at(tet)];
  return split_tets(mesh, {tet}, n, place);
}

/// In the middle of what lies in one tet, between a crossed face and the next crossing.
std::int32_t insert_between_crossings(LocalRemeshing& mesh, const Edge& edge,
                                      const SegmentWalk& walk,
                                      const std::vector<DoubleDouble>& shares) {
  const FinePoint a = mesh.fine_point(edge[0]), b = mesh.fine_point(edge[1]);
  for (std::size_t i = 0; i < shares.size(); ++i) {
    const FaceHandle face = walk.crossings[i].face;
    if (face == no_face) continue;
    const FaceHandle beyond = mesh.complex().neighbours[at(tet_of(face))][at(face_of(face))];
    TF_CHECK(beyond != no_face);  // the segment is inside
    const DoubleDouble end = i + 1 < shares.size() ? shares[i + 1] : DoubleDouble{1, 0};
    const DoubleDouble start = i > 0 ? shares[i - 1] : DoubleDouble{0, 0};
    for (const auto& [tet, other_end] : {std::pair{tet_of(beyond), end}, {tet_of(face), start}}) {
      const Place place{edge, between(a, b, one_half * (shares[i] + other_end))};
      const std::int32_t node = split_tet(mesh, tet, place);
      if (node >= 0) return node;
    }
  }
  return -1;
}

}  // namespace

std::int32_t insert_on_edge(LocalRemeshing& mesh, const RecoverySurface& surface, const Edge& edge,
                            const SegmentWalk& walk) {
  const std::size_t n = walk.crossings.size();
  TF_CHECK(n > 0);
  std::vector<DoubleDouble> shares(n);
  std::vector<std::size_t> order(n);
  for (std::size_t k = 0; k < n; ++k) {
    shares[k] = share_of_crossing(mesh, walk.crossings[k], edge);
    order[k] = (n / 2 + k) % n;
  }
  // The middle one first, but none that leaves a stump while there is another.
  std::stable_partition(order.begin(), order.end(), [&shares](std::size_t i) {
    return shares[i].high > 0.01 && shares[i].high < 0.99;
  });
  const FinePoint a = mesh.fine_point(edge[0]), b = mesh.fine_point(edge[1]);
  for (const std::size_t i : order) {
    const std::int32_t node =
        split_crossing(mesh, surface, walk.crossings[i], {edge, between(a, b, shares[i])});
    if (node >= 0) return node;
  }
  return insert_between_crossings(mesh, edge, walk, shares);
}

std::int32_t insert_on_face(LocalRemeshing& mesh, const RecoverySurface& surface,
                            const Triangle& face) {
  const std::vector<Edge> edges = piercing_edges(mesh, face);
  std::vector<FinePoint> places;
  for (const Edge& edge : edges) {
    places.push_back(between(mesh.fine_point(edge[0]), mesh.fine_point(edge[1]),
                             share_at_plane(mesh, face, edge)));
  }
  const Vec3 centroid = (mesh.point(face[0]) + mesh.point(face[1]) + mesh.point(face[2])) / 3.0;
  std::vector<std::size_t> order(edges.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
    return distance(places[i].high, centroid) < distance(places[j].high, centroid);
  });
  for (const std::size_t i : order) {
    const std::int32_t node = split_crossing(mesh, surface, {no_face, edges[i]}, {face, places[i]});
    if (node >= 0) return node;
  }
  // Between two edges of one tet the face runs through the inside of it.
  for (const std::size_t i : order) {
    const auto ring = mesh.ring(edges[i][0], edges[i][1]);
    if (!ring) continue;
    for (const std::int32_t t : ring->tets) {
      for (std::size_t j = 0; j < edges.size(); ++j) {
        if (j == i || mesh.complex().local_node(t, edges[j][0]) < 0 ||
            mesh.complex().local_node(t, edges[j][1]) < 0) {
          continue;
        }
        const std::int32_t node =
            split_tet(mesh, t, {face, between(places[i], places[j], one_half)});
        if (node >= 0) return node;
      }
    }
  }
  return -1;
}

}  // namespace tetfarm
