#include "mesh/volume/boundary_recovery.h"

#include <algorithm>

#include "base/check.h"
#include "mesh/geometry/cavity_insertion.h"
#include "mesh/geometry/predicates.h"
#include "mesh/geometry/triangle_intersection.h"
#include "mesh/volume/edge_recovery.h"
#include "mesh/volume/face_recovery.h"

namespace tetfarm {
namespace {

using Edge = std::array<std::int32_t, 2>;

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

/// How deep and how long a pass searches for each thing that is missing.
struct Effort {
  int depth;
  std::int64_t rings;
};
constexpr std::array<Effort, 4> efforts = {{{0, 200}, {1, 1000}, {2, 2000}, {3, 5000}}};

/// Splitting ends after so many rounds, or when there are more Steiner points than triangles.
constexpr int most_rounds = 12;

void recover_edges(LocalRemeshing& mesh, EdgeRemoval& removal, std::vector<Edge>& missing) {
  for (std::size_t pass = 0; pass < efforts.size() && !missing.empty();) {
    const std::size_t before = missing.size();
    std::erase_if(missing, [&](const Edge& edge) {
      removal.set_budget(efforts[pass].rings);
      return recover_edge(mesh, removal, edge[0], edge[1], efforts[pass].depth);
    });
    if (missing.size() == before) ++pass;
  }
}

void recover_faces(LocalRemeshing& mesh, EdgeRemoval& removal, const RecoverySurface& surface,
                   std::vector<std::int32_t>& missing) {
  for (std::size_t pass = 0; pass < efforts.size() && !missing.empty();) {
    const std::size_t before = missing.size();
    std::erase_if(missing, [&](std::int32_t number) {
      const Triangle& face = surface.triangles()[at(number)];
      removal.set_budget(efforts[pass].rings);
      if (!recover_face(mesh, removal, face, efforts[pass].depth)) return false;
      mesh.constrain(mesh.find_face(face[0], face[1], face[2]), true);
      return true;
    });
    if (missing.size() == before) ++pass;
  }
}

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

/// A point on the missing face: where the middle one of the piercing edges goes through it.
Vec3 place_on_face(const LocalRemeshing& mesh, const Triangle& face) {
  const Vec3& a = mesh.point(face[0]);
  const Vec3& b = mesh.point(face[1]);
  const Vec3& c = mesh.point(face[2]);
  const Vec3 centroid = (a + b + c) / 3.0;
  const auto edges = piercing_edges(mesh, face);
  if (edges.empty()) return centroid;
  const auto& [u, v] = edges[edges.size() / 2];
  const double above = std::abs(tet_volume(a, b, c, mesh.point(u)));
  const double below = std::abs(tet_volume(a, b, c, mesh.point(v)));
  if (!(above + below > 0)) return centroid;
  const Vec3 through = mesh.point(u) + (above / (above + below)) * (mesh.point(v) - mesh.point(u));
  // Well inside the face.
  return centroid + 0.8 * (through - centroid);
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

/// What one round of flips over the whole surface leaves missing.
struct Missing {
  std::vector<Edge> edges;
  std::vector<std::int32_t> faces;
  std::int64_t edges_at_first = 0;
  std::int64_t faces_at_first = 0;
};

Missing recover_by_flips(LocalRemeshing& mesh, const RecoverySurface& surface) {
  Missing missing;
  EdgeRemoval removal(mesh, surface);
  missing.edges = missing_edges(mesh.complex(), surface);
  missing.edges_at_first = static_cast<std::int64_t>(missing.edges.size());
  recover_edges(mesh, removal, missing.edges);
  missing.faces = constrain_faces(mesh, surface);
  missing.faces_at_first = static_cast<std::int64_t>(missing.faces.size());
  recover_faces(mesh, removal, surface, missing.faces);
  return missing;
}

/// A point on the missing edge where the middle one of its crossings is, else at another one.
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

bool holds_edge(const Triangle& t, const Edge& edge) {
  const auto holds = [&t](std::int32_t v) { return t[0] == v || t[1] == v || t[2] == v; };
  return holds(edge[0]) && holds(edge[1]);
}

/// Splits every missing edge, and every missing face whose edges are all there. False: no point had
/// room.
bool split_missing(TetComplex& complex, std::vector<std::uint8_t>& constrained,
                   const Missing& missing, SplitSurface& surface) {
  bool is_split = false;
  for (const Edge& edge : missing.edges) {
    SegmentWalk walk;
    {
      const LocalRemeshing mesh(complex, constrained);
      walk = walk_segment(mesh, edge[0], edge[1]);
      // A point inserted for another edge may have brought this one back.
      if (walk.is_edge || walk.crossings.empty()) continue;
    }
    const std::int32_t node = insert_on_edge(complex, constrained, edge, walk);
    if (node < 0) continue;
    split_edge(surface, edge[0], edge[1], node);
    is_split = true;
  }
  for (const std::int32_t number : missing.faces) {
    const Triangle face = surface.triangles[at(number)];
    const bool has_missing_edge =
        std::any_of(missing.edges.begin(), missing.edges.end(),
                    [&face](const Edge& edge) { return holds_edge(face, edge); });
    if (has_missing_edge) continue;
    Vec3 place;
    {
      const LocalRemeshing mesh(complex, constrained);
      place = place_on_face(mesh, face);
    }
    const std::int32_t node = insert_point(complex, constrained, place, face[0]);
    if (node < 0) continue;
    split_face(surface, number, node);
    is_split = true;
  }
  return is_split;
}

}  // namespace

std::vector<Edge> missing_edges(const TetComplex& complex, const RecoverySurface& surface) {
  std::vector<Edge> edges = surface.edges();
  std::vector<std::uint8_t> is_there(edges.size(), 0);
  constexpr std::array<std::array<std::size_t, 2>, 6> ends = {
      {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};
  std::vector<std::size_t> begin(at(surface.nodes()) + 1, 0);
  for (const Edge& edge : edges) ++begin[at(edge[0]) + 1];
  for (std::size_t v = 1; v < begin.size(); ++v) begin[v] += begin[v - 1];
  for (std::size_t t = 0; t < complex.nodes.size(); ++t) {
    if (!complex.is_live(static_cast<std::int32_t>(t))) continue;
    for (const auto& [i, j] : ends) {
      const auto [low, high] = std::minmax(complex.nodes[t][i], complex.nodes[t][j]);
      if (high >= surface.nodes()) continue;
      const auto first = edges.begin() + static_cast<std::ptrdiff_t>(begin[at(low)]);
      const auto last = edges.begin() + static_cast<std::ptrdiff_t>(begin[at(low) + 1]);
      const auto it = std::lower_bound(first, last, Edge{low, high});
      if (it != last && (*it)[1] == high)
        is_there[static_cast<std::size_t>(it - edges.begin())] = 1;
    }
  }
  std::vector<Edge> missing;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (is_there[i] == 0) missing.push_back(edges[i]);
  }
  return missing;
}

std::vector<std::int32_t> constrain_faces(LocalRemeshing& mesh, const RecoverySurface& surface) {
  std::vector<std::uint8_t> is_there(surface.triangles().size(), 0);
  const TetComplex& complex = mesh.complex();
  for (std::size_t t = 0; t < complex.nodes.size(); ++t) {
    if (!complex.is_live(static_cast<std::int32_t>(t))) continue;
    for (int f = 0; f < 4; ++f) {
      const auto& k = tet_face_nodes[at(f)];
      const Tet& n = complex.nodes[t];
      const std::int32_t a = n[at(k[0])], b = n[at(k[1])], c = n[at(k[2])];
      if (std::max({a, b, c}) >= surface.nodes()) continue;
      const std::int32_t number = surface.find_triangle(a, b, c);
      if (number < 0) continue;
      is_there[at(number)] = 1;
      mesh.constrain(face_handle(static_cast<std::int32_t>(t), f), true);
    }
  }
  std::vector<std::int32_t> missing;
  for (std::size_t i = 0; i < is_there.size(); ++i) {
    if (is_there[i] == 0) missing.push_back(static_cast<std::int32_t>(i));
  }
  return missing;
}

RecoveredBoundary recover_boundary(TetComplex& complex, std::vector<std::uint8_t>& constrained,
                                   const std::vector<Triangle>& triangles) {
  RecoveredBoundary result;
  result.surface = unsplit(triangles);
  for (int round = 0;; ++round) {
    LocalRemeshing mesh(complex, constrained);
    const auto nodes = static_cast<std::int32_t>(complex.points.size());
    const Missing missing =
        recover_by_flips(mesh, RecoverySurface(result.surface.triangles, nodes));
    if (round == 0) {
      result.missing_edges = missing.edges_at_first;
      result.missing_faces = missing.faces_at_first;
    }
    if (missing.faces.empty()) return result;
    if (round < most_rounds && result.surface.splits.size() <= triangles.size() &&
        split_missing(complex, constrained, missing, result.surface)) {
      continue;
    }
    for (const std::int32_t number : missing.faces) {
      result.lost.push_back(result.surface.source[at(number)]);
    }
    std::sort(result.lost.begin(), result.lost.end());
    result.lost.erase(std::unique(result.lost.begin(), result.lost.end()), result.lost.end());
    return result;
  }
}

}  // namespace tetfarm
