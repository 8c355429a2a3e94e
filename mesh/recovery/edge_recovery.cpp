#include "mesh/recovery/edge_recovery.h"

#include <algorithm>

#include "base/array_index.h"
#include "base/check.h"

namespace tetfarm {
namespace {

/// How the ray from a through b leaves the tet of a's star: the weights of the three other nodes,
/// of which only the signs are exact.
struct Cone {
  std::array<std::int32_t, 3> nodes;  // (a, nodes) is positive
  std::array<double, 3> weight;
};

Cone cone_of(const LocalRemeshing& mesh, std::int32_t tet, std::int32_t a, std::int32_t b) {
  const Tet& n = mesh.complex().nodes[at(tet)];
  const auto& f = tet_face_nodes[at(mesh.complex().local_node(tet, a))];
  // Outward from a: (f0, f1, f2, a) is negative, so is (a, f2, f1, f0) turned: (a, f0, f1, f2)
  // positive.
  Cone cone{{n[at(f[0])], n[at(f[1])], n[at(f[2])]}, {}};
  const auto& [x, y, z] = cone.nodes;
  cone.weight = {mesh.orient(a, b, y, z), mesh.orient(a, x, b, z), mesh.orient(a, x, y, b)};
  return cone;
}

/// The first crossing, found in the star of a; sets is_edge or node_on_it when there is none.
Crossing first_crossing(const LocalRemeshing& mesh, std::int32_t a, std::int32_t b,
                        SegmentWalk& walk) {
  const auto star = mesh.star(a);
  for (const std::int32_t t : star) {
    if (mesh.complex().local_node(t, b) >= 0) {
      walk.is_edge = true;
      return {};
    }
  }
  for (const std::int32_t t : star) {
    const Cone cone = cone_of(mesh, t, a, b);
    if (cone.weight[0] < 0 || cone.weight[1] < 0 || cone.weight[2] < 0) continue;
    std::array<std::int32_t, 3> carrying{};
    std::size_t count = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      if (cone.weight[k] > 0) carrying[count++] = cone.nodes[k];
    }
    if (count == 3) return {face_handle(t, mesh.complex().local_node(t, a)), {-1, -1}};
    if (count == 2) return {no_face, {carrying[0], carrying[1]}};
    if (count == 1) {
      walk.node_on_it = carrying[0];
      return {};
    }
  }
  return {};
}

/// The crossing after a face: through another face of the tet beyond, or one of its edges; sets
/// node_on_it when it is the tet's apex.
Crossing next_crossing(const LocalRemeshing& mesh, FaceHandle beyond, std::int32_t a,
                       std::int32_t b, std::int32_t apex, SegmentWalk& walk) {
  const std::int32_t t = tet_of(beyond);
  const Tet& n = mesh.complex().nodes[at(t)];
  const auto& f = tet_face_nodes[at(face_of(beyond))];
  // Seen from beyond, x turns anticlockwise round the line.
  const std::array<std::int32_t, 3> x = {n[at(f[0])], n[at(f[2])], n[at(f[1])]};
  std::array<int, 3> side{};
  for (std::size_t k = 0; k < 3; ++k) {
    const double s = mesh.orient(a, b, x[k], apex);
    side[k] = (s > 0) - (s < 0);
  }
  if (side[0] == 0 && side[1] == 0 && side[2] == 0) walk.node_on_it = apex;
  for (std::size_t k = 0; k < 3; ++k) {
    if (side[k] == 0 && side[(k + 1) % 3] > 0 && side[(k + 2) % 3] < 0) {
      return {no_face, {x[k], apex}};
    }
  }
  for (std::size_t k = 0; k < 3; ++k) {
    // The line passes between the edges to x[k] and x[k + 1].
    if (side[k] < 0 && side[(k + 1) % 3] > 0) {
      return {face_handle(t, mesh.complex().local_node(t, x[(k + 2) % 3])), {-1, -1}};
    }
  }
  return {};
}

}  // namespace

SegmentWalk walk_segment(const LocalRemeshing& mesh, std::int32_t a, std::int32_t b) {
  TF_CHECK(a != b);
  SegmentWalk walk;
  Crossing crossing = first_crossing(mesh, a, b, walk);
  constexpr std::size_t most_crossings = 100000;
  while (crossing.face != no_face && walk.crossings.size() < most_crossings) {
    walk.crossings.push_back(crossing);
    const FaceHandle beyond =
        mesh.complex().neighbours[at(tet_of(crossing.face))][at(face_of(crossing.face))];
    if (beyond == no_face) return walk;
    const std::int32_t apex = mesh.complex().nodes[at(tet_of(beyond))][at(face_of(beyond))];
    if (apex == b) return walk;
    crossing = next_crossing(mesh, beyond, a, b, apex, walk);
  }
  if (crossing.edge[0] >= 0) walk.crossings.push_back(crossing);
  return walk;
}

namespace {

/// A face by a 2-3 flip, else by those of its edges round which it is not convex with the tets on
/// its two sides.
bool clear_face(LocalRemeshing& mesh, EdgeRemoval& removal, FaceHandle face,
                const RecoveryGuard& guard, int depth) {
  const TetComplex& complex = mesh.complex();
  const std::int32_t below = tet_of(face);
  const FaceHandle other = complex.neighbours[at(below)][at(face_of(face))];
  if (other == no_face) return false;
  if (removal.remove_face(face, guard)) return true;
  const std::array<std::int32_t, 3> x = complex.face_nodes(face);
  const std::int32_t low = complex.nodes[at(below)][at(face_of(face))];
  const std::int32_t high = complex.nodes[at(tet_of(other))][at(face_of(other))];
  for (std::size_t k = 0; k < 3; ++k) {
    const std::int32_t u = x[k], v = x[(k + 1) % 3];
    if (mesh.orient(low, high, u, v) > 0) continue;
    const std::size_t mark = mesh.mark();
    if (removal.remove(below, u, v, guard, depth)) return true;
    // The ring became shorter: who asked looks again at what is in the way.
    if (mesh.mark() != mark) return false;
  }
  return false;
}

bool clear(LocalRemeshing& mesh, EdgeRemoval& removal, const Crossing& crossing,
           const RecoveryGuard& guard, int depth) {
  if (crossing.face != no_face) return clear_face(mesh, removal, crossing.face, guard, depth);
  return removal.remove(crossing.edge[0], crossing.edge[1], guard, depth);
}

/// Whether something that was in the way from a to b is not any longer.
bool clear_one(LocalRemeshing& mesh, EdgeRemoval& removal, std::int32_t a, std::int32_t b,
               const RecoveryGuard& guard, int depth) {
  SegmentWalk walk = walk_segment(mesh, a, b);
  for (std::size_t k = 0; k < walk.crossings.size(); ++k) {
    const std::size_t mark = mesh.mark();
    if (clear(mesh, removal, walk.crossings[k], guard, depth)) return true;
    if (mesh.mark() != mark) walk = walk_segment(mesh, a, b);
  }
  return false;
}

}  // namespace

bool recover_edge(LocalRemeshing& mesh, EdgeRemoval& removal, std::int32_t a, std::int32_t b,
                  int depth) {
  TF_CHECK(depth >= 0);
  const RecoveryGuard guard = RecoveryGuard::of_edge(mesh, a, b);
  bool is_nearer = true;
  while (is_nearer) {
    const SegmentWalk walk = walk_segment(mesh, a, b);
    if (walk.is_edge) return true;
    if (walk.node_on_it >= 0) return false;
    is_nearer = clear_one(mesh, removal, a, b, guard, depth) ||
                clear_one(mesh, removal, b, a, guard, depth);
    mesh.forget_journal();
  }
  return false;
}

}  // namespace tetfarm
