#include "mesh/cosmetics/joint_splitting.h"

#include <algorithm>

#include "base/check.h"
#include "mesh/cosmetics/altitude_improvement.h"
#include "mesh/cosmetics/element_splitting.h"
#include "mesh/cosmetics/joint_climbing.h"
#include "mesh/cosmetics/quality.h"

namespace tetfarm::cosmetics {
namespace {

double height2_of(const WorkMesh& work, const Tet& tet) {
  const auto& [a, b, c, d] = tet;
  return smallest_height2(work.point(a), work.point(b), work.point(c), work.point(d));
}

/// The squared height of the lowest tet in the place of the patch before the split.
double lowest_before(const WorkMesh& work, const NodePatch& patch, const Replacement& undoing) {
  double lowest2 = HUGE_VAL;
  for (const Tet& tet : undoing.new_tets) lowest2 = std::min(lowest2, height2_of(work, tet));
  for (const std::int32_t t : patch.tets) {
    const auto& made = undoing.old_tets;
    if (std::find(made.begin(), made.end(), t) != made.end()) continue;
    lowest2 = std::min(lowest2, height2_of(work, work.tet(t)));
  }
  return lowest2;
}

}  // namespace

std::vector<std::int32_t> split_together(WorkMesh& work, std::int32_t t, double enough,
                                         double least_distance) {
  const double before = work.quality_of(t);
  const auto found = find_split(work, t, {enough, least_distance, true});
  if (!found) return {};
  Replacement undoing{{}, {}, found->new_worst, found->old_worst, std::nullopt};
  for (const std::int32_t old : found->old_tets) undoing.new_tets.push_back(work.tet(old));
  undoing.old_tets = replace_tets(work, *found);
  if (undoing.old_tets.empty()) return {};
  NodePatch patch = patch_round(work, undoing.old_tets.front());
  const GuardedQuality measure{before, lowest_before(work, patch, undoing)};
  const double after = climb_together(patch, enough, measure);
  if (is_worth(before, after) && move_patch(work, patch)) return std::move(patch.tets);
  TF_CHECK(!replace_tets(work, undoing).empty());
  return {};
}

}  // namespace tetfarm::cosmetics
