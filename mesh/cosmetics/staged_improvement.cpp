#include "mesh/cosmetics/staged_improvement.h"

#include <algorithm>
#include <array>
#include <utility>

#include "base/check.h"
#include "mesh/cosmetics/quality.h"

namespace tetfarm::cosmetics {

namespace {

/// More than one in so many tets below the angle: the surface is one of needles.
constexpr double needle_deg = 8;
constexpr std::size_t tets_a_needle = 50;
/// A change must make the worst by this factor better; less is not worth its time.
constexpr double gain_among_needles = 1.1;
constexpr int most_passes = 3;
/// What every stage may try, however few are bad.
constexpr std::int64_t least_attempts = 1000;
/// All stages together have so many attempts for each node of the boundary, and some more: needles
/// a thousand times as long as wide have many tets each, and hardly one of these can be helped.
constexpr std::int64_t attempts_of_boundary_node = 200;
constexpr std::int64_t more_attempts = 10'000;

/// Tets below the angle are worked on until they are good enough; so many attempts for each two,
/// until this share of all attempts is spent.
struct Stage {
  double wanted_deg;
  double enough_deg;
  std::int64_t attempts_of_two;
  double share_until_then;
};
constexpr std::array<Stage, 4> stages = {
    {{0.5, 20, 10, 0.65}, {3, 20, 8, 0.85}, {8, 25, 2, 0.9}, {15, 30, 1, 0.92}}};
constexpr std::int64_t attempts_of_last_stage = 1;
constexpr double share_until_last_stage = 0.94;
constexpr std::array<Stage, 2> stages_again = {{{3, 20, 10, 0.98}, {1, 20, 20, 1}}};

/// Those below the improver's aims.
std::vector<BadTet> bad_tets(const Improver& improver) {
  std::vector<BadTet> bad;
  const auto tets = static_cast<std::int32_t>(improver.work.complex.nodes.size());
  for (std::int32_t t = 0; t < tets; ++t) {
    if (!improver.work.complex.is_live(t)) continue;
    if (improver.options.regular.holds(t) && improver.work.is_untouched(t)) continue;
    const double now = improver.work.quality_of(t);
    if (now < improver.aims.wanted) bad.push_back({now, t});
  }
  return bad;
}

/// Other aims make what was settled open again. The tets that fall short of them.
std::vector<BadTet> take_aims(Improver& improver, const Aims& aims) {
  improver.aims = aims;
  improver.queue = {};
  improver.given_up.clear();
  improver.node2settled.clear();
  return bad_tets(improver);
}

std::int64_t attempts_until(const Improver& improver, double share) {
  TF_CHECK(share > 0 && share <= 1);
  const std::int64_t all = more_attempts + attempts_of_boundary_node * improver.work.fixed_nodes;
  return static_cast<std::int64_t>(share * static_cast<double>(all)) - improver.report.attempts;
}

void begin_stage(Improver& improver, const Aims& aims, std::int64_t attempts_of_two, double share) {
  std::vector<BadTet> bad = take_aims(improver, aims);
  const std::int64_t wanted = least_attempts + attempts_of_two * std::ssize(bad) / 2;
  improver.attempts = std::min(wanted, std::max(least_attempts, attempts_until(improver, share)));
  improver.queue = std::priority_queue<BadTet>(std::less<BadTet>(), std::move(bad));
}

void run_stage(Improver& improver, const Stage& stage) {
  const double wanted = quality_of_angle(stage.wanted_deg);
  begin_stage(improver, {wanted, wanted, quality_of_angle(stage.enough_deg)}, stage.attempts_of_two,
              stage.share_until_then);
  for (int pass = 0; pass < most_passes && !improver.queue.empty(); ++pass) {
    begin_pass(improver);
    run_pass(improver, true);
    requeue(improver, false);
  }
  try_last_resorts(improver);
}

}  // namespace

bool is_of_needles(const std::vector<BadTet>& bad, std::size_t tets) {
  const double limit = quality_of_angle(needle_deg);
  const auto needles = std::count_if(bad.begin(), bad.end(),
                                     [limit](const BadTet& tet) { return tet.quality < limit; });
  return static_cast<std::size_t>(needles) * tets_a_needle > tets;
}

void improve_in_stages(Improver& improver) {
  const Aims aims = improver.aims;
  improver.work.gain = gain_among_needles;
  for (const Stage& stage : stages) run_stage(improver, stage);
  begin_stage(improver, aims, attempts_of_last_stage, share_until_last_stage);
}

void improve_worst_again(Improver& improver) {
  const Aims aims = improver.aims;
  for (const Stage& stage : stages_again) {
    improver.failures_beside_flat =
        std::max(improver.failures_beside_flat, most_failures_beside_flat);
    run_stage(improver, stage);
  }
  for (const BadTet& bad : take_aims(improver, aims)) {
    improver.given_up.push_back({bad, improver.work.changes});
  }
  improver.attempts = least_attempts;
}

}  // namespace tetfarm::cosmetics
