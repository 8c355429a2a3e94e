#include "mesh/recovery/steiner_settling.h"

#include <algorithm>
#include <span>

#include "base/array_index.h"
#include "base/check.h"
#include "mesh/recovery/edge_removal_by_flips.h"
#include "mesh/recovery/kernel_point.h"
#include "mesh/recovery/recovery_guard.h"
#include "mesh/recovery/star_growth.h"

namespace tetfarm {
namespace {

std::vector<std::int32_t> neighbours_of(const LocalRemeshing& mesh, std::int32_t node,
                                        const std::vector<std::int32_t>& star) {
  std::vector<std::int32_t> nodes;
  for (const std::int32_t t : star) {
    for (const std::int32_t v : mesh.complex().nodes[at(t)]) {
      if (v != node) nodes.push_back(v);
    }
  }
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

/// The one tet in place of the four round a node; false when it would not be positive.
bool merge_four(LocalRemeshing& mesh, std::int32_t node, const std::vector<std::int32_t>& star,
                const std::vector<std::int32_t>& neighbours) {
  Tet whole = mesh.complex().nodes[at(star[0])];
  const auto other = std::find_if(neighbours.begin(), neighbours.end(), [&](std::int32_t v) {
    return mesh.complex().local_node(star[0], v) < 0;
  });
  TF_CHECK(other != neighbours.end());
  std::replace(whole.begin(), whole.end(), node, *other);
  if (mesh.orient(whole[0], whole[1], whole[2], whole[3]) <= 0) return false;
  mesh.replace(star, std::span(&whole, 1));
  return true;
}

bool remove_one_edge(LocalRemeshing& mesh, EdgeRemoval& removal, std::int32_t node,
                     const std::vector<std::int32_t>& neighbours) {
  const RecoveryGuard guard = RecoveryGuard::of_nothing(mesh);
  for (const int depth : {0, 1}) {
    for (const std::int32_t v : neighbours) {
      if (removal.remove(node, v, guard, depth)) return true;
    }
  }
  return false;
}

/// The faces round the node, as seen from it.
std::vector<VisibleFace> link_of(const LocalRemeshing& mesh, std::int32_t node) {
  std::vector<VisibleFace> faces;
  const auto p = [&mesh](std::int32_t v) { return mesh.fine_point(v); };
  for (const std::int32_t t : mesh.star(node)) {
    const auto& f = tet_face_nodes[at(mesh.complex().local_node(t, node))];
    const Tet& n = mesh.complex().nodes[at(t)];
    faces.push_back({p(n[at(f[0])]), p(n[at(f[2])]), p(n[at(f[1])])});
  }
  return faces;
}

/// To the middle of its room, and onto doubles if that leaves all tets positive; else it gets more
/// room.
void centre(LocalRemeshing& mesh, std::int32_t node) {
  const auto faces = link_of(mesh, node);
  const auto place = kernel_point(faces, mesh.fine_point(node));
  if (!place) return;
  const FinePoint plain = fine(place->high);
  if (sees_all(faces, plain)) {
    mesh.move_point(node, plain);
  } else if (!grow_star(mesh, node)) {
    mesh.move_point(node, *place);
  }
}

}  // namespace

bool remove_node(LocalRemeshing& mesh, std::int32_t node) {
  return remove_node(mesh, RecoverySurface({}, 0), node);
}

bool remove_node(LocalRemeshing& mesh, const RecoverySurface& surface, std::int32_t node) {
  EdgeRemoval removal(mesh, surface);
  constexpr std::int64_t most_rings = 2000;
  removal.set_budget(most_rings);
  const std::size_t mark = mesh.mark();
  constexpr int most_flips = 200;
  for (int flips = 0; flips < most_flips; ++flips) {
    const auto star = mesh.star(node);
    const auto neighbours = neighbours_of(mesh, node, star);
    if (star.size() == 4 && neighbours.size() == 4) {
      if (!merge_four(mesh, node, star, neighbours)) break;
      mesh.forget_journal();
      return true;
    }
    if (!remove_one_edge(mesh, removal, node, neighbours)) break;
  }
  mesh.roll_back(mark);
  return false;
}

void settle_steiner_point(LocalRemeshing& mesh, std::int32_t point) {
  if (mesh.complex().node2tet[at(point)] < 0 || remove_node(mesh, point)) return;
  centre(mesh, point);
}

SettledPoints settle_steiner_points(LocalRemeshing& mesh, const std::vector<std::int32_t>& points,
                                    const WorkProgress& progress) {
  SettledPoints result;
  constexpr int most_sweeps = 20;
  for (int sweep = 0; sweep < most_sweeps; ++sweep) {
    // All move, also those that have a place: the room of one is that of its neighbours.
    for (const std::int32_t v : points) {
      settle_steiner_point(mesh, v);
      progress.add(0);
    }
    result = {};
    for (const std::int32_t v : points) {
      if (mesh.complex().node2tet[at(v)] < 0) continue;
      (mesh.fine_point(v).is_plain() ? result.kept : result.unsettled).push_back(v);
    }
    if (result.unsettled.empty()) break;
  }
  return result;
}

}  // namespace tetfarm
