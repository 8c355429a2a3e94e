#include "mesh/recovery/star_growth.h"

#include <algorithm>
#include <optional>
#include <vector>

#include "base/array_index.h"
#include "base/check.h"
#include "mesh/recovery/kernel_point.h"

namespace tetfarm {
namespace {

constexpr int most_tets_taken_in = 16;
/// Faces that hem the node in, of which the tets beyond are tried.
constexpr std::size_t most_tried = 12;

Triangle face_nodes(const LocalRemeshing& mesh, FaceHandle face) {
  const Tet& n = mesh.complex().nodes[at(tet_of(face))];
  const auto& f = tet_face_nodes[at(face_of(face))];
  return {n[at(f[0])], n[at(f[1])], n[at(f[2])]};
}

bool holds(const std::vector<std::int32_t>& list, std::int32_t x) {
  return std::find(list.begin(), list.end(), x) != list.end();
}

/// Tets that the node shall be joined to the hull of, and where it would lie.
struct Cavity {
  std::vector<std::int32_t> tets;
  std::vector<FaceHandle> hull;  // faces of these tets
  FinePoint place;
  double room = 0;
};

std::vector<FaceHandle> hull_of(const LocalRemeshing& mesh, const std::vector<std::int32_t>& tets,
                                std::int32_t node) {
  std::vector<FaceHandle> hull;
  for (const std::int32_t t : tets) {
    for (int f = 0; f < 4; ++f) {
      const FaceHandle other = mesh.complex().neighbours[at(t)][at(f)];
      // Within the star all faces hold the node.
      const auto nodes = face_nodes(mesh, face_handle(t, f));
      const bool at_node = nodes[0] == node || nodes[1] == node || nodes[2] == node;
      if (at_node || (other != no_face && holds(tets, tet_of(other)))) continue;
      hull.push_back(face_handle(t, f));
    }
  }
  return hull;
}

std::vector<VisibleFace> seen_faces(const LocalRemeshing& mesh,
                                    const std::vector<FaceHandle>& hull) {
  std::vector<VisibleFace> faces;
  for (const FaceHandle face : hull) {
    const auto [a, b, c] = face_nodes(mesh, face);
    faces.push_back({mesh.fine_point(a), mesh.fine_point(c), mesh.fine_point(b)});
  }
  return faces;
}

/// Finds the place of the most room. False when there is none.
bool find_room(const LocalRemeshing& mesh, const FinePoint& start, Cavity& cavity) {
  const auto faces = seen_faces(mesh, cavity.hull);
  const auto place = kernel_point(faces, start);
  if (!place) return false;
  cavity.place = *place;
  cavity.room = room_at(faces, *place);
  return true;
}

/// Whether the cavity stays a ball without anything inside when the tet is taken in: its nodes
/// beyond shared faces are new to the hull, and no node or constrained face is swallowed.
bool may_take_in(const LocalRemeshing& mesh, const Cavity& cavity, std::int32_t tet) {
  int shared = 0;
  std::int32_t beyond = -1;
  for (int f = 0; f < 4; ++f) {
    const FaceHandle other = mesh.complex().neighbours[at(tet)][at(f)];
    if (other == no_face || !holds(cavity.tets, tet_of(other))) continue;
    if (mesh.is_constrained(other)) return false;
    ++shared;
    beyond = mesh.complex().nodes[at(tet)][at(f)];
  }
  if (shared != 1) return shared == 2;
  return std::none_of(cavity.hull.begin(), cavity.hull.end(), [&](FaceHandle face) {
    const auto nodes = face_nodes(mesh, face);
    return std::find(nodes.begin(), nodes.end(), beyond) != nodes.end();
  });
}

/// The faces of the hull that can be gone through, the nearest to the place first.
std::vector<FaceHandle> hemming_faces(const LocalRemeshing& mesh, const Cavity& cavity) {
  std::vector<std::pair<double, FaceHandle>> sorted;
  for (const FaceHandle face : cavity.hull) {
    if (mesh.is_constrained(face)) continue;
    const FaceHandle beyond = mesh.complex().neighbours[at(tet_of(face))][at(face_of(face))];
    if (beyond == no_face) continue;
    sorted.emplace_back(room_at(seen_faces(mesh, {face}), cavity.place), beyond);
  }
  std::sort(sorted.begin(), sorted.end());
  std::vector<FaceHandle> faces;
  for (std::size_t i = 0; i < std::min(sorted.size(), most_tried); ++i) {
    faces.push_back(sorted[i].second);
  }
  return faces;
}

/// The cavity with one more tet, of those near the place the one that leaves the most room.
std::optional<Cavity> grown(const LocalRemeshing& mesh, const Cavity& cavity, std::int32_t node) {
  std::optional<Cavity> best;
  for (const FaceHandle face : hemming_faces(mesh, cavity)) {
    if (!may_take_in(mesh, cavity, tet_of(face))) continue;
    Cavity larger = cavity;
    larger.tets.push_back(tet_of(face));
    larger.hull = hull_of(mesh, larger.tets, node);
    if (!find_room(mesh, cavity.place, larger)) continue;
    if (!best || larger.room > best->room) best = std::move(larger);
  }
  return best;
}

void fill(LocalRemeshing& mesh, const Cavity& cavity, std::int32_t node) {
  TF_CHECK(cavity.hull.size() >= 4);
  std::vector<Tet> tets;
  for (const FaceHandle face : cavity.hull) {
    const auto [a, b, c] = face_nodes(mesh, face);
    tets.push_back({a, c, b, node});
  }
  mesh.move_point(node, fine(cavity.place.high));
  mesh.replace(cavity.tets, tets);
  mesh.forget_journal();
}

}  // namespace

bool grow_star(LocalRemeshing& mesh, std::int32_t node) {
  Cavity cavity;
  cavity.tets = mesh.star(node);
  cavity.hull = hull_of(mesh, cavity.tets, node);
  if (!find_room(mesh, mesh.fine_point(node), cavity)) return false;
  for (int taken = 0; taken < most_tets_taken_in; ++taken) {
    auto larger = grown(mesh, cavity, node);
    if (!larger) return false;
    cavity = std::move(*larger);
    if (!sees_all(seen_faces(mesh, cavity.hull), fine(cavity.place.high))) continue;
    fill(mesh, cavity, node);
    return true;
  }
  return false;
}

}  // namespace tetfarm
