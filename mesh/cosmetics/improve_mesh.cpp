#include "mesh/cosmetics/improve_mesh.h"

#include <algorithm>
#include <cmath>
#include <queue>

#include "base/check.h"
#include "mesh/cosmetics/bad_tets.h"
#include "mesh/cosmetics/edge_removal.h"
#include "mesh/cosmetics/element_collapse.h"
#include "mesh/cosmetics/element_splitting.h"
#include "mesh/cosmetics/face_swapping.h"
#include "mesh/cosmetics/height_raising.h"
#include "mesh/cosmetics/joint_climbing.h"
#include "mesh/cosmetics/joint_splitting.h"
#include "mesh/cosmetics/quality.h"
#include "mesh/cosmetics/relaxation.h"
#include "mesh/cosmetics/small_polyhedron_reconnection.h"
#include "mesh/cosmetics/smoothing.h"

namespace tetfarm {

namespace {

using cosmetics::BadTet;
using cosmetics::Replacement;
using cosmetics::WorkMesh;

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

/// No operation is sought beyond this: time is better spent on the next bad tet.
constexpr double enough_deg = 40;
/// An edge from a collapse is no longer, one from a split no shorter, than this times the spacing.
constexpr double longest_collapse = 1.6;
constexpr double shortest_split = 0.4;
/// For tets that are not so bad: one more node in a thin place would cost height and elements.
constexpr double shortest_mild_split = 0.6;
/// What is still worse than this at the end may be split at a shorter distance: where the surface's
/// own nodes lie that near to each other, no node at the other distance can help.
constexpr double desperate_deg = 8;
constexpr double shortest_near_split = 0.1;
/// The lowest tet that is stuck bounds the time step, whatever is done to the others; a few more
/// are tried, as now and then raising them sets it free.
constexpr std::int64_t most_stuck_heights = 4;

/// A bad tet that nothing helped, and the number of changes made until then.
struct GivenUp {
  BadTet bad;
  std::int64_t changes;
};

struct Improver {
  WorkMesh work;
  const CosmeticOptions& options;
  double wanted;
  double rebuilt;
  double enough;
  CosmeticReport report;
  std::priority_queue<BadTet> queue;
  std::vector<GivenUp> given_up;
  /// Number of changes when no better place was found for a node; until its ball changes there is
  /// none.
  std::vector<std::int64_t> node2settled;

  bool is_settled(std::int32_t node) const {
    return at(node) < node2settled.size() && node2settled[at(node)] >= work.node2change[at(node)];
  }
  void settle(std::int32_t node) {
    if (at(node) >= node2settled.size()) node2settled.resize(work.node2change.size(), -1);
    node2settled[at(node)] = work.changes;
  }
  void queue_bad(const std::vector<std::int32_t>& tets) {
    for (const std::int32_t t : tets) {
      const double now = work.goodness_of(t);
      if (now < wanted) queue.push({now, t});
    }
  }
  bool is_current(const BadTet& bad) const {
    return work.complex.is_live(bad.tet) && work.goodness_of(bad.tet) == bad.goodness;
  }
};

bool apply(Improver& improver, const Replacement& replacement) {
  const std::vector<std::int32_t> tets = cosmetics::replace_tets(improver.work, replacement);
  improver.queue_bad(tets);
  return !tets.empty();
}

bool swap(Improver& improver, const BadTet& bad) {
  const WorkMesh& work = improver.work;
  std::optional<Replacement> best;
  double beat = bad.goodness;
  const auto take = [&](std::optional<Replacement> found) {
    if (!found) return;
    beat = found->new_worst;
    best = std::move(found);
  };
  for (const auto& [i, j] : cosmetics::edges_by_angle(work, bad.tet)) {
    if (beat >= improver.enough) break;
    take(cosmetics::find_edge_removal(work, bad.tet, i, j, beat));
  }
  for (int face = 0; face < 4 && beat < improver.enough; ++face) {
    take(cosmetics::find_face_removal(work, bad.tet, face, beat));
  }
  if (!best || !apply(improver, *best)) return false;
  ++improver.report.swaps;
  return true;
}

bool smooth(Improver& improver, const BadTet& bad) {
  WorkMesh& work = improver.work;
  const Tet tet = work.tet(bad.tet);
  bool moved = false;
  for (const std::int32_t node : tet) {
    if (!work.may_move(node) || improver.is_settled(node)) continue;
    const std::vector<std::int32_t> ball = cosmetics::ball_of_node(work, node);
    const auto place = cosmetics::is_inner(work, ball, node)
                           ? cosmetics::find_move(work, ball, node, improver.enough)
                           : std::nullopt;
    if (!place || !cosmetics::move_node(work, ball, node, place->point)) {
      improver.settle(node);
      continue;
    }
    improver.queue_bad(ball);
    ++improver.report.moves;
    moved = true;
    if (work.goodness_of(bad.tet) >= improver.wanted) break;
  }
  return moved;
}

bool is_short_enough(const Improver& improver, const Replacement& collapse, std::int32_t onto) {
  if (!improver.options.spacing) return true;
  const Vec3& centre = improver.work.point(onto);
  const double longest = longest_collapse * improver.options.spacing(centre);
  for (const Tet& tet : collapse.new_tets) {
    for (const std::int32_t v : tet) {
      if (norm2(improver.work.point(v) - centre) > longest * longest) return false;
    }
  }
  return true;
}

bool collapse(Improver& improver, const BadTet& bad, double least) {
  WorkMesh& work = improver.work;
  const Tet tet = work.tet(bad.tet);
  std::optional<Replacement> best;
  double beat = std::max(bad.goodness, least);
  for (const std::int32_t node : tet) {
    if (!work.may_move(node)) continue;
    const std::vector<std::int32_t> ball = cosmetics::ball_of_node(work, node);
    if (!cosmetics::is_inner(work, ball, node)) continue;
    for (const std::int32_t onto : tet) {
      if (onto == node) continue;
      auto found = cosmetics::find_collapse(work, ball, node, onto, beat);
      if (!found || !is_short_enough(improver, *found, onto)) continue;
      beat = found->new_worst;
      best = std::move(found);
    }
  }
  if (!best || !apply(improver, *best)) return false;
  ++improver.report.collapses;
  return true;
}

/// As many spacings as that, at the centre of the tet.
double length_at(const Improver& improver, const BadTet& bad, double spacings) {
  if (!improver.options.spacing) return 0;
  Vec3 centre;
  for (const std::int32_t v : improver.work.tet(bad.tet)) centre += 0.25 * improver.work.point(v);
  return spacings * improver.options.spacing(centre);
}

bool split(Improver& improver, const BadTet& bad, double shortest, double least) {
  const cosmetics::SplitOptions options{.enough = improver.enough,
                                        .least_distance = length_at(improver, bad, shortest)};
  const auto found = cosmetics::find_split(improver.work, bad.tet, options);
  if (!found || found->new_worst < least || !apply(improver, *found)) return false;
  ++improver.report.splits;
  return true;
}

/// Collapses or splits a tet that is bad enough for any gain, or that can be made good.
bool rebuild(Improver& improver, const BadTet& bad) {
  const bool takes_any = bad.goodness < improver.rebuilt;
  if (!takes_any && !improver.options.rebuilds_to_wanted) return false;
  const double least = takes_any ? 0 : improver.wanted;
  const double shortest = takes_any ? shortest_split : shortest_mild_split;
  return collapse(improver, bad, least) || split(improver, bad, shortest, least);
}

/// Works the queue off, worst first. Collapses and splits change the number of nodes and cost most,
/// so they wait for a `thorough` pass, when swaps and moves have done what they can.
void run_pass(Improver& improver, bool thorough) {
  while (!improver.queue.empty()) {
    const BadTet bad = improver.queue.top();
    improver.queue.pop();
    if (!improver.is_current(bad)) continue;
    if (swap(improver, bad) || smooth(improver, bad)) continue;
    if (thorough && rebuild(improver, bad)) continue;
    improver.given_up.push_back({bad, improver.work.changes});
  }
}

/// Queues again the tets that were given up, when something near them has changed since, or when
/// the next pass is the first `thorough` one and may do more for them.
void requeue(Improver& improver, bool thorough) {
  std::vector<GivenUp> kept;
  for (const GivenUp& item : improver.given_up) {
    if (!improver.is_current(item.bad)) continue;
    const Tet& tet = improver.work.tet(item.bad.tet);
    const bool changed = std::any_of(tet.begin(), tet.end(), [&](std::int32_t v) {
      return improver.work.node2change[at(v)] > item.changes;
    });
    const bool rebuildable =
        item.bad.goodness < improver.rebuilt || improver.options.rebuilds_to_wanted;
    if (changed || (thorough && rebuildable)) {
      improver.queue.push(item.bad);
    } else {
      kept.push_back(item);
    }
  }
  improver.given_up = std::move(kept);
}

/// The tets that were given up below this goodness, worst first.
std::vector<BadTet> worst_given_up(const Improver& improver, double below) {
  std::vector<BadTet> worst;
  for (const GivenUp& item : improver.given_up) {
    if (improver.is_current(item.bad) && item.bad.goodness < below) worst.push_back(item.bad);
  }
  std::sort(worst.begin(), worst.end(), [](const BadTet& a, const BadTet& b) { return b < a; });
  return worst;
}

/// A last resort: small cavities round the tets that were given up are searched for their best
/// filling. What gets better may give others room, so all operations are tried there once more.
void reconnect_worst(Improver& improver) {
  cosmetics::ReconnectionOptions options;
  options.enough = improver.enough;
  for (const BadTet& bad : worst_given_up(improver, improver.rebuilt)) {
    if (!improver.is_current(bad)) continue;
    const auto found = cosmetics::find_reconnection(improver.work, bad.tet, options);
    if (!found || !apply(improver, *found)) continue;
    ++improver.report.reconnections;
    run_pass(improver, true);
  }
}

/// The very last resort, for the few that nothing helped.
void split_desperate(Improver& improver) {
  for (const BadTet& bad : worst_given_up(improver, cosmetics::goodness_of_angle(desperate_deg))) {
    if (!improver.is_current(bad)) continue;
    if (split(improver, bad, shortest_near_split, 0)) run_pass(improver, true);
  }
}

void try_last_resorts(Improver& improver) {
  reconnect_worst(improver);
  split_desperate(improver);
}

/// Where no node can help by itself: neighbours move at once.
void move_together(Improver& improver) {
  std::int64_t failures = 0;
  for (const BadTet& bad : worst_given_up(improver, improver.wanted)) {
    if (failures == improver.options.most_joint_failures) return;
    if (!improver.is_current(bad)) continue;
    const auto changed = cosmetics::improve_together(improver.work, bad.tet, improver.wanted);
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
  const double distance = length_at(improver, bad, shortest_near_split);
  auto changed = cosmetics::split_together(improver.work, bad.tet, improver.enough, distance);
  improver.report.splits += changed.empty() ? 0 : 1;
  return changed;
}

/// Worst first; when a few of them cannot be helped, the smallest angle is what it is. Nothing is
/// done here that does not heed heights.
void split_worst(Improver& improver) {
  const double below = cosmetics::goodness_of_angle(improver.options.jointly_split_dihedral_deg);
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
      const double now = improver.work.goodness_of(t);
      if (now < improver.wanted) improver.given_up.push_back({{now, t}, improver.work.changes});
    }
  }
}

cosmetics::HeightOptions heights_of(const CosmeticOptions& options, double floor) {
  cosmetics::HeightOptions heights;
  heights.wanted_length = options.height_in_smallest_spacings * options.smallest_spacing;
  heights.floor = floor;
  heights.most_joint_failures = options.most_joint_failures;
  heights.traded_goodness = cosmetics::goodness_of_angle(options.rebuilt_dihedral_deg);
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

}  // namespace

CosmeticReport improve_mesh(TetComplex& complex, std::int32_t fixed_nodes,
                            const CosmeticOptions& options) {
  if (complex.live_tets() == 0) return {};
  const cosmetics::GoodnessLimits limits{
      cosmetics::goodness_of_angle(options.wanted_dihedral_deg),
      cosmetics::goodness_of_angle(options.relaxed_dihedral_deg)};
  const cosmetics::HeightOptions heights = heights_of(options, limits.wanted);
  cosmetics::BadTetScan before = cosmetics::scan_for_bad_tets(complex, limits, options);
  CosmeticReport report;
  report.min_dihedral_before_deg = before.min_dihedral_deg;
  report.min_dihedral_after_deg = before.min_dihedral_deg;
  if (before.bad.empty() && before.to_relax.empty() && !heights.wants_any()) return report;
  Improver improver{
      .work = WorkMesh(complex, fixed_nodes),
      .options = options,
      .wanted = limits.wanted,
      .rebuilt = cosmetics::goodness_of_angle(options.rebuilt_dihedral_deg),
      .enough = cosmetics::goodness_of_angle(std::max(enough_deg, options.wanted_dihedral_deg)),
      .report = report,
      .queue = std::priority_queue<BadTet>(std::less<BadTet>(), std::move(before.bad)),
      .given_up = {},
      .node2settled = {}};
  improver.work.tet2goodness = std::move(before.tet2goodness);
  for (int pass = 0; pass < options.most_passes; ++pass) {
    run_pass(improver, pass > 0);
    requeue(improver, pass == 0);
    if (improver.queue.empty()) break;
  }
  try_last_resorts(improver);
  improver.report.moves += cosmetics::relax_nodes(improver.work, before.to_relax, improver.wanted);
  // Rounder surroundings may have given them room.
  requeue(improver, false);
  run_pass(improver, true);
  try_last_resorts(improver);
  move_together(improver);
  if (heights.wants_any()) {
    improver.report.moves += cosmetics::raise_heights(improver.work, heights);
  }
  split_worst(improver);
  if (options.measures_angles) {
    improver.report.min_dihedral_after_deg =
        cosmetics::min_dihedral_deg(improver.work, options.regular);
  }
  return improver.report;
}

}  // namespace tetfarm
