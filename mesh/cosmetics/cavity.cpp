#include "mesh/cosmetics/cavity.h"

#include <algorithm>
#include <cmath>

#include "base/array_index.h"
#include "base/check.h"
#include "mesh/core/tet_replacement.h"
#include "mesh/cosmetics/quality.h"

namespace tetfarm::cosmetics {

namespace {

void add_point(WorkMesh& work, const Vec3& point) {
  TF_CHECK(work.node2change.size() == work.complex.points.size());
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
      marks(complex_.nodes.size()),
      tet2quality(complex_.nodes.size(), std::numeric_limits<double>::quiet_NaN()) {
  TF_CHECK(fixed_nodes >= 0 && at(fixed_nodes) <= complex.points.size());
}

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
  TF_CHECK(work.complex.node2tet[at(node)] >= 0);  // some tet holds it
  std::vector<std::int32_t> ball;
  ball.reserve(32);
  work.marks.clear();
  const Tet* const tets = work.complex.nodes.data();
  const std::array<FaceHandle, 4>* const neighbours = work.complex.neighbours.data();
  // Each tet is met three times, mostly not in the caches: it is called for when it is first seen.
  const auto take = [&](std::int32_t t) {
    __builtin_prefetch(&tets[at(t)]);
    __builtin_prefetch(&neighbours[at(t)]);
    work.marks.add(t);
    ball.push_back(t);
  };
  take(work.complex.node2tet[at(node)]);
  for (std::size_t i = 0; i < ball.size(); ++i) {
    const Tet& tet = tets[at(ball[i])];
    const std::array<FaceHandle, 4>& across = neighbours[at(ball[i])];
    for (std::size_t face = 0; face < 4; ++face) {
      if (tet[face] == node || across[face] == no_face) continue;
      const std::int32_t beyond = tet_of(across[face]);
      if (!work.marks.has(beyond)) take(beyond);
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
  TF_CHECK(i != j);
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
  const std::vector<Tet>& new_tets = replacement.new_tets;
  TF_CHECK(!replacement.old_tets.empty() && !new_tets.empty());
  if (replacement.new_point) add_point(work, *replacement.new_point);
  const std::vector<OpenFace> faces =
      open_faces(complex, replacement.old_tets, new_tets, work.marks);
  const bool valid =
      are_pairs(faces) && std::all_of(new_tets.begin(), new_tets.end(),
                                      [&](const Tet& tet) { return is_positive(complex, tet); });
  if (!valid) {
    if (replacement.new_point) drop_last_point(work);
    return {};
  }
  ++work.changes;
  for (const std::int32_t t : replacement.old_tets) {
    for (const std::int32_t v : work.tet(t)) work.node2change[at(v)] = work.changes;
  }
  std::vector<std::int32_t> numbers = exchange_tets(complex, replacement.old_tets, new_tets);
  work.marks.make_room(complex.nodes.size());
  work.tet2quality.resize(complex.nodes.size());
  for (const std::int32_t t : numbers) work.forget_quality_of(t);
  if (replacement.new_point) work.node2change.back() = work.changes;
  glue_pairs(complex, faces, numbers);
  TF_CHECK(work.tet2quality.size() == complex.nodes.size());
  return numbers;
}

}  // namespace tetfarm::cosmetics
