#include "mesh/cosmetics/face_swapping.h"

#include <algorithm>

#include "base/check.h"
#include "mesh/cosmetics/quality.h"

namespace tetfarm::cosmetics {

namespace {

constexpr int most_depth = 3;

/// A face between two apexes: the tet above holds `above`, the one below holds `below`.
struct Sandwich {
  std::int32_t above_tet;
  std::int32_t below_tet;
};

/// What becomes of the patch beyond an edge of it.
struct Growth {
  double old_worst = 1;
  double new_worst = 1;
  std::vector<std::int32_t> old_tets;
  std::vector<Tet> new_tets;

  void add(const Growth& more) {
    old_worst = std::min(old_worst, more.old_worst);
    new_worst = std::min(new_worst, more.new_worst);
    old_tets.insert(old_tets.end(), more.old_tets.begin(), more.old_tets.end());
    new_tets.insert(new_tets.end(), more.new_tets.begin(), more.new_tets.end());
  }
};

struct Patch {
  const WorkMesh& work;
  std::int32_t above;
  std::int32_t below;
};

std::int32_t node_beside(const WorkMesh& work, std::int32_t t, std::int32_t a, std::int32_t b,
                         std::int32_t c) {
  for (const std::int32_t v : work.tet(t)) {
    if (v != a && v != b && v != c) return v;
  }
  return -1;
}

/// The face beyond edge uv of the sandwich, with its third node, when it too lies between the
/// apexes.
struct NextFace {
  Sandwich sandwich;
  std::int32_t node;
};
std::optional<NextFace> next_face(const Patch& patch, const Sandwich& now, std::int32_t third) {
  const WorkMesh& work = patch.work;
  const auto beyond = [&](std::int32_t t) { return work.across(t, work.local_node(t, third)); };
  const FaceHandle above = beyond(now.above_tet);
  const FaceHandle below = beyond(now.below_tet);
  if (above == no_face || below == no_face) return std::nullopt;
  const std::int32_t top = tet_of(above);
  const std::int32_t bottom = tet_of(below);
  const FaceHandle between = work.across(top, work.local_node(top, patch.above));
  if (between == no_face || tet_of(between) != bottom) return std::nullopt;
  if (work.local_node(bottom, patch.below) != face_of(between)) return std::nullopt;
  return NextFace{{top, bottom}, work.tet(top)[static_cast<std::size_t>(face_of(above))]};
}

/// The best of closing the patch at edge uv, or growing it over the face beyond. The node `third`
/// is that of the sandwich that is not on uv. As long as depth lasts, and closing is bad.
Growth grow(const Patch& patch, const Sandwich& now, std::array<std::int32_t, 3> uv_third,
            int depth) {
  const auto [u, v, third] = uv_third;
  Growth closed;
  closed.new_tets = {{patch.below, patch.above, u, v}};
  closed.new_worst = quality(patch.work.complex, closed.new_tets[0]);
  if (depth == 0) return closed;
  const std::optional<NextFace> next = next_face(patch, now, third);
  if (!next) return closed;
  Growth grown;
  grown.old_tets = {next->sandwich.above_tet, next->sandwich.below_tet};
  grown.old_worst = worst_of(patch.work, grown.old_tets);
  for (const auto& edge : {std::array{u, next->node, v}, std::array{next->node, v, u}}) {
    grown.add(grow(patch, next->sandwich, edge, depth - 1));
    if (grown.new_worst <= closed.new_worst) return closed;
  }
  return grown;
}

}  // namespace

std::optional<Replacement> find_face_removal(const WorkMesh& work, std::int32_t t, int face,
                                             double beat) {
  const FaceHandle across = work.across(t, face);
  if (across == no_face) return std::nullopt;
  const Tet& tet = work.tet(t);
  const auto& local = tet_face_nodes[static_cast<std::size_t>(face)];
  // Anticlockwise as seen from t's own apex, which is the one above.
  const std::array<std::int32_t, 3> nodes = {tet[static_cast<std::size_t>(local[2])],
                                             tet[static_cast<std::size_t>(local[1])],
                                             tet[static_cast<std::size_t>(local[0])]};
  const Patch patch{work, tet[static_cast<std::size_t>(face)],
                    node_beside(work, tet_of(across), nodes[0], nodes[1], nodes[2])};
  TF_CHECK(patch.below >= 0);
  Growth growth;
  growth.old_tets = {t, tet_of(across)};
  growth.old_worst = worst_of(work, growth.old_tets);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::array edge = {nodes[i], nodes[(i + 1) % 3], nodes[(i + 2) % 3]};
    growth.add(grow(patch, {t, tet_of(across)}, edge, most_depth));
    if (growth.new_worst <= std::max(beat, 0.0)) return std::nullopt;
  }
  if (!is_worth(growth.old_worst, growth.new_worst, work.gain)) return std::nullopt;
  return Replacement{std::move(growth.old_tets), std::move(growth.new_tets), growth.old_worst,
                     growth.new_worst, std::nullopt};
}

}  // namespace tetfarm::cosmetics
