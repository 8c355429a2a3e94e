#include "mesh/cosmetics/improve_mesh.h"

#include <algorithm>

#include "base/check.h"
#include "mesh/cosmetics/altitude_improvement.h"
#include "mesh/cosmetics/bad_tets.h"
#include "mesh/cosmetics/improver.h"
#include "mesh/cosmetics/joint_climbing.h"
#include "mesh/cosmetics/joint_splitting.h"
#include "mesh/cosmetics/quality.h"
#include "mesh/cosmetics/relaxation.h"
#include "mesh/cosmetics/staged_improvement.h"

namespace tetfarm {

namespace {

using cosmetics::BadTet;
using cosmetics::Improver;
using cosmetics::WorkMesh;

/// No operation is sought beyond this: time is better spent on the next bad tet.
constexpr double enough_deg = 40;
/// The lowest tet that is stuck bounds the time step, whatever is done to the others; a few more
/// are tried, as now and then raising them sets it free.
constexpr std::int64_t most_stuck_heights = 4;

/// Where no node can help by itself: neighbours move at once.
void move_together(Improver& improver) {
  std::int64_t failures = 0;
  for (const BadTet& bad : worst_given_up(improver, improver.aims.wanted)) {
    if (failures == improver.options.most_joint_failures) return;
    if (!improver.is_current(bad)) continue;
    const auto changed = cosmetics::improve_together(improver.work, bad.tet, improver.aims.wanted);
    if (changed.empty()) {
      ++failures;
      continue;
    }
    ++improver.report.joint_moves;
    improver.queue_bad(changed);
    run_pass(improver, true);
  }
}

/// Where no node that is there can help: one is put near to others, and they move with it. The tets
/// that were changed, or none.
std::vector<std::int32_t> split_together(Improver& improver, const BadTet& bad) {
  const double distance = length_at(improver, bad, cosmetics::shortest_near_split);
  auto changed = cosmetics::split_together(improver.work, bad.tet, improver.aims.enough, distance);
  improver.report.splits += changed.empty() ? 0 : 1;
  return changed;
}

/// Worst first; when a few of them cannot be helped, the smallest angle is what it is. Nothing is
/// done here that does not heed heights.
void split_worst(Improver& improver) {
  const double below = cosmetics::quality_of_angle(improver.options.jointly_split_dihedral_deg);
  std::vector<BadTet> failed;
  while (std::ssize(failed) < improver.options.most_joint_failures) {
    const std::vector<BadTet> worst = worst_given_up(improver, below);
    const auto next = std::find_if(worst.begin(), worst.end(), [&failed](const BadTet& bad) {
      return std::find(failed.begin(), failed.end(), bad) == failed.end();
    });
    if (next == worst.end()) return;
    const auto changed = split_together(improver, *next);
    if (changed.empty()) failed.push_back(*next);
    for (const std::int32_t t : changed) {
      const double now = improver.work.quality_of(t);
      if (now < improver.aims.wanted)
        improver.given_up.push_back({{now, t}, improver.work.changes});
    }
  }
}

cosmetics::HeightOptions heights_of(const CosmeticOptions& options, double floor) {
  cosmetics::HeightOptions heights;
  heights.wanted_length = options.height_in_smallest_spacings * options.smallest_spacing;
  heights.floor = floor;
  heights.most_joint_failures = options.most_joint_failures;
  heights.traded_quality = cosmetics::quality_of_angle(options.rebuilt_dihedral_deg);
  const RegularTets& regular = options.regular;
  if (regular.least_height > heights.wanted_length && options.height_in_spacings == 0) {
    heights.is_high_at_first = [&regular](std::int32_t t) { return regular.holds(t); };
  }
  if (options.height_in_spacings == 0) heights.most_stuck = most_stuck_heights;
  if (options.spacing) {
    heights.wanted_spacings = options.height_in_spacings;
    heights.spacing = options.spacing;
  }
  return heights;
}

/// Far more than meshes take whose triangles fit the wanted sizes; no mesh takes more.
std::int64_t most_attempts(std::size_t tets) {
  return 100'000 + 20 * static_cast<std::int64_t>(tets);
}

}  // namespace

CosmeticReport improve_mesh(TetComplex& complex, std::int32_t fixed_nodes,
                            const CosmeticOptions& options) {
  if (complex.live_tets() == 0) return {};
  options.progress.begin(WorkStage::cosmetics);
  const cosmetics::QualityLimits limits{cosmetics::quality_of_angle(options.wanted_dihedral_deg),
                                        cosmetics::quality_of_angle(options.relaxed_dihedral_deg)};
  const cosmetics::HeightOptions heights = heights_of(options, limits.wanted);
  cosmetics::BadTetScan before = cosmetics::scan_for_bad_tets(complex, limits, options);
  const bool is_of_needles = cosmetics::is_of_needles(before.bad, complex.live_tets());
  CosmeticReport report;
  report.min_dihedral_before_deg = before.min_dihedral_deg;
  report.min_dihedral_after_deg = before.min_dihedral_deg;
  if (before.bad.empty() && before.to_relax.empty() && !heights.wants_any()) return report;
  Improver improver{
      .work = WorkMesh(complex, fixed_nodes),
      .options = options,
      .aims = {limits.wanted, cosmetics::quality_of_angle(options.rebuilt_dihedral_deg),
               cosmetics::quality_of_angle(std::max(enough_deg, options.wanted_dihedral_deg))},
      .report = report,
      .queue = std::priority_queue<BadTet>(std::less<BadTet>(), std::move(before.bad)),
      .given_up = {},
      .node2settled = {},
      .attempts = most_attempts(complex.live_tets())};
  TF_CHECK(before.tet2quality.size() == complex.nodes.size());
  improver.work.tet2quality = std::move(before.tet2quality);
  if (is_of_needles) cosmetics::improve_in_stages(improver);
  for (int pass = 0; pass < options.most_passes; ++pass) {
    begin_pass(improver);
    run_pass(improver, pass > 0);
    requeue(improver, pass == 0);
    if (improver.queue.empty()) break;
  }
  options.progress.next_pass();
  try_last_resorts(improver);
  improver.report.moves +=
      cosmetics::relax_nodes(improver.work, before.to_relax, improver.aims.wanted);
  // Rounder surroundings may have given them room.
  requeue(improver, false);
  begin_pass(improver);
  run_pass(improver, true);
  try_last_resorts(improver);
  options.progress.next_pass();
  if (is_of_needles) cosmetics::improve_worst_again(improver);
  move_together(improver);
  if (heights.wants_any()) {
    improver.report.moves += cosmetics::improve_altitudes(improver.work, heights);
  }
  split_worst(improver);
  if (options.measures_angles) {
    improver.report.min_dihedral_after_deg =
        cosmetics::min_dihedral_deg(improver.work, options.regular);
  }
  return improver.report;
}

}  // namespace tetfarm
