#include "mesh/cosmetics/cavity.h"

#include <algorithm>
#include <cmath>

#include "base/array_index.h"
#include "mesh/core/sorted_face.h"
#include "mesh/cosmetics/quality.h"

namespace tetfarm::cosmetics {

namespace {

/// A face that needs a partner: an outer face of the cavity, or one of a new tet.
struct OpenFace {
  std::array<std::int32_t, 3> nodes;
  /// Face of the tet outside, or of the new tet by its place in the list.
  FaceHandle handle;
  bool outer;
  /// Outer faces run as seen from the old tet, so two faces that meet run alike when one is outer.
  bool odd;

  friend bool operator<(const OpenFace& a, const OpenFace& b) {
    if (a.nodes != b.nodes) return a.nodes < b.nodes;
    return a.outer != b.outer ? a.outer : a.handle < b.handle;
  }
};

OpenFace open_face(const Tet& tet, int face, FaceHandle handle, bool outer) {
  const auto& local = tet_face_nodes[at(face)];
  OpenFace open{{tet[at(local[0])], tet[at(local[1])], tet[at(local[2])]}, handle, outer, false};
  open.odd = sort_face(open.nodes);
  return open;
}

std::vector<OpenFace> open_faces(WorkMesh& work, const Replacement& replacement) {
  std::vector<OpenFace> faces;
  faces.reserve(4 * (replacement.old_tets.size() + replacement.new_tets.size()));
  work.clear_marks();
  for (const std::int32_t t : replacement.old_tets) work.set_mark(t);
  for (const std::int32_t t : replacement.old_tets) {
    for (int face = 0; face < 4; ++face) {
      const FaceHandle across = work.across(t, face);
      if (across != no_face && work.is_marked(tet_of(across))) continue;
      faces.push_back(open_face(work.tet(t), face, across, true));
    }
  }
  for (std::size_t i = 0; i < replacement.new_tets.size(); ++i) {
    for (int face = 0; face < 4; ++face) {
      const FaceHandle handle = face_handle(static_cast<std::int32_t>(i), face);
      faces.push_back(open_face(replacement.new_tets[i], face, handle, false));
    }
  }
  std::sort(faces.begin(), faces.end());
  return faces;
}

/// True when the faces come in pairs that fit together.
bool match(const std::vector<OpenFace>& faces) {
  if (faces.size() % 2 != 0) return false;
  for (std::size_t i = 0; i < faces.size(); i += 2) {
    const OpenFace& a = faces[i];
    const OpenFace& b = faces[i + 1];
    if (a.nodes != b.nodes || b.outer || (a.odd == b.odd) != a.outer) return false;
    if (i > 0 && faces[i - 1].nodes == a.nodes) return false;
  }
  return true;
}

void glue_pairs(TetComplex& complex, const std::vector<OpenFace>& faces,
                const std::vector<std::int32_t>& new_tets) {
  for (std::size_t i = 0; i < faces.size(); i += 2) {
    const auto handle = [&](const OpenFace& face) {
      if (face.outer) return face.handle;
      return face_handle(new_tets[at(tet_of(face.handle))], face_of(face.handle));
    };
    complex.glue(handle(faces[i]), handle(faces[i + 1]));
  }
}

void add_point(WorkMesh& work, const Vec3& point) {
  work.complex.points.push_back(point);
  work.complex.node2tet.push_back(-1);
  work.node2change.push_back(0);
}

void drop_last_point(WorkMesh& work) {
  work.complex.points.pop_back();
  work.complex.node2tet.pop_back();
  work.node2change.pop_back();
}

}  // namespace

WorkMesh::WorkMesh(TetComplex& complex_, std::int32_t fixed_nodes_)
    : complex(complex_),
      fixed_nodes(fixed_nodes_),
      node2change(complex_.points.size(), 0),
      tet2mark(complex_.nodes.size(), 0),
      tet2quality(complex_.nodes.size(), std::numeric_limits<double>::quiet_NaN()) {}

double WorkMesh::quality_of(std::int32_t t) const {
  double& known = tet2quality[at(t)];
  if (std::isnan(known)) known = quality(complex, tet(t));
  return known;
}

double worst_of(const WorkMesh& work, const std::vector<std::int32_t>& tets) {
  double worst = 1;
  for (const std::int32_t t : tets) worst = std::min(worst, work.quality_of(t));
  return worst;
}

std::vector<std::int32_t> ball_of_node(WorkMesh& work, std::int32_t node) {
  std::vector<std::int32_t> ball;
  ball.reserve(32);
  work.clear_marks();
  const Tet* const tets = work.complex.nodes.data();
  const std::array<FaceHandle, 4>* const neighbours = work.complex.neighbours.data();
  // Each tet is met three times, mostly not in the caches: it is called for when it is first seen.
  const auto take = [&](std::int32_t t) {
    __builtin_prefetch(&tets[at(t)]);
    __builtin_prefetch(&neighbours[at(t)]);
    work.set_mark(t);
    ball.push_back(t);
  };
  take(work.complex.node2tet[at(node)]);
  for (std::size_t i = 0; i < ball.size(); ++i) {
    const Tet& tet = tets[at(ball[i])];
    const std::array<FaceHandle, 4>& across = neighbours[at(ball[i])];
    for (std::size_t face = 0; face < 4; ++face) {
      if (tet[face] == node || across[face] == no_face) continue;
      const std::int32_t beyond = tet_of(across[face]);
      if (!work.is_marked(beyond)) take(beyond);
    }
  }
  return ball;
}

bool is_inner(const WorkMesh& work, const std::vector<std::int32_t>& ball, std::int32_t node) {
  if (!work.may_move(node)) return false;
  for (const std::int32_t t : ball) {
    for (int face = 0; face < 4; ++face) {
      if (work.tet(t)[at(face)] != node && work.across(t, face) == no_face) return false;
    }
  }
  return true;
}

std::optional<EdgeRing> ring_of_edge(const WorkMesh& work, std::int32_t t, int i, int j,
                                     std::size_t most) {
  // The other two nodes k, l such that (i, j, k, l) is an even permutation of the tet.
  static constexpr std::array<std::array<int, 4>, 4> third = {
      {{-1, 2, 3, 1}, {3, -1, 0, 2}, {1, 3, -1, 0}, {2, 0, 1, -1}}};
  const int k = third[at(i)][at(j)];
  EdgeRing ring{work.tet(t)[at(i)], work.tet(t)[at(j)], {}, {}};
  ring.nodes.reserve(most);
  ring.tets.reserve(most);
  std::int32_t node = work.tet(t)[at(k)];
  std::int32_t now = t;
  do {
    if (ring.tets.size() == most) return std::nullopt;
    ring.tets.push_back(now);
    ring.nodes.push_back(node);
    const FaceHandle across = work.across(now, work.local_node(now, node));
    if (across == no_face) return std::nullopt;
    // The node that now and the next tet share besides the edge: of four, three are known.
    const Tet& tet = work.tet(now);
    node = tet[0] ^ tet[1] ^ tet[2] ^ tet[3] ^ ring.from ^ ring.to ^ node;
    now = tet_of(across);
  } while (now != t);
  return ring;
}

std::vector<std::int32_t> replace_tets(WorkMesh& work, const Replacement& replacement) {
  TetComplex& complex = work.complex;
  if (replacement.new_point) add_point(work, *replacement.new_point);
  const std::vector<OpenFace> faces = open_faces(work, replacement);
  const bool valid =
      match(faces) && std::all_of(replacement.new_tets.begin(), replacement.new_tets.end(),
                                  [&](const Tet& tet) { return is_positive(complex, tet); });
  if (!valid) {
    if (replacement.new_point) drop_last_point(work);
    return {};
  }
  ++work.changes;
  for (const std::int32_t t : replacement.old_tets) {
    for (const std::int32_t v : work.tet(t)) {
      work.node2change[at(v)] = work.changes;
      complex.node2tet[at(v)] = -1;
    }
    complex.kill_tet(t);
  }
  std::vector<std::int32_t> new_tets;
  for (const Tet& tet : replacement.new_tets) {
    const std::int32_t t = complex.new_tet();
    if (at(t) >= work.tet2mark.size()) {
      work.tet2mark.resize(complex.nodes.size(), 0);
      work.tet2quality.resize(complex.nodes.size());
    }
    complex.nodes[at(t)] = tet;
    work.forget_quality_of(t);
    for (const std::int32_t v : tet) complex.node2tet[at(v)] = t;
    new_tets.push_back(t);
  }
  if (replacement.new_point) work.node2change.back() = work.changes;
  glue_pairs(complex, faces, new_tets);
  return new_tets;
}

}  // namespace tetfarm::cosmetics
