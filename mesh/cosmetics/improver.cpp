#include "mesh/cosmetics/improver.h"

#include <algorithm>

#include "base/check.h"
#include "mesh/cosmetics/edge_removal.h"
#include "mesh/cosmetics/element_collapse.h"
#include "mesh/cosmetics/element_splitting.h"
#include "mesh/cosmetics/face_swapping.h"
#include "mesh/cosmetics/quality.h"
#include "mesh/cosmetics/small_polyhedron_reconnection.h"
#include "mesh/cosmetics/smoothing.h"

namespace tetfarm::cosmetics {

namespace {

/// An edge from a collapse is no longer, one from a split no shorter, than this times the spacing.
constexpr double longest_collapse = 1.6;
constexpr double shortest_split = 0.4;
/// For tets that are not so bad: one more node in a thin place would cost height and elements.
constexpr double shortest_mild_split = 0.6;
/// What is still worse than this at the end may be split at a shorter distance: where the surface's
/// own nodes lie that near to each other, no node at the other distance can help.
constexpr double desperate_deg = 8;
/// What is flatter than this may be one of a whole layer of flat tets.
constexpr double flat_deg = 2;
/// What the search for the best filling of a cavity counts for.
constexpr std::int64_t attempts_of_reconnection = 4;
/// What the search for places beside a flat tet counts for.
constexpr std::int64_t attempts_of_flat = 3;
/// So many of these may fail for each that does not: on surfaces of nothing but needles nearly all
/// do.
constexpr std::int64_t failures_for_success = 10;
/// A pass is told after so many tries; of each some ten thousand instructions are spent at least.
constexpr int tell_every = 64;

bool apply(Improver& improver, const Replacement& replacement) {
  const std::vector<std::int32_t> tets = replace_tets(improver.work, replacement);
  improver.queue_bad(tets);
  return !tets.empty();
}

bool swap(Improver& improver, const BadTet& bad) {
  const WorkMesh& work = improver.work;
  std::optional<Replacement> best;
  double beat = bad.quality;
  const auto take = [&](std::optional<Replacement> found) {
    if (!found) return;
    beat = found->new_worst;
    best = std::move(found);
  };
  for (const auto& [i, j] : edges_by_angle(work, bad.tet)) {
    if (beat >= improver.aims.enough) break;
    take(find_edge_removal(work, bad.tet, i, j, beat));
  }
  for (int face = 0; face < 4 && beat < improver.aims.enough; ++face) {
    take(find_face_removal(work, bad.tet, face, beat));
  }
  TF_CHECK(!best || best->new_worst > bad.quality);
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
    const std::vector<std::int32_t> ball = ball_of_node(work, node);
    const auto place = is_inner(work, ball, node)
                           ? find_move(work, ball, node, improver.aims.enough)
                           : std::nullopt;
    if (!place || !move_node(work, ball, node, place->point)) {
      improver.settle(node);
      continue;
    }
    improver.queue_bad(ball);
    ++improver.report.moves;
    moved = true;
    if (work.quality_of(bad.tet) >= improver.aims.wanted) break;
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
  double beat = std::max(bad.quality, least);
  for (const std::int32_t node : tet) {
    if (!work.may_move(node)) continue;
    const std::vector<std::int32_t> ball = ball_of_node(work, node);
    if (!is_inner(work, ball, node)) continue;
    for (const std::int32_t onto : tet) {
      if (onto == node) continue;
      auto found = find_collapse(work, ball, node, onto, beat);
      if (!found || !is_short_enough(improver, *found, onto)) continue;
      beat = found->new_worst;
      best = std::move(found);
    }
  }
  TF_CHECK(!best || best->new_worst > std::max(bad.quality, least));
  if (!best || !apply(improver, *best)) return false;
  ++improver.report.collapses;
  return true;
}

/// A flat tet is also split from beside its plane, as long as that works often enough.
bool split(Improver& improver, const BadTet& bad, double shortest, double least) {
  const bool is_flat =
      bad.quality < quality_of_angle(flat_deg) && improver.failures_beside_flat > 0;
  const SplitOptions options{.enough = improver.aims.enough,
                             .least_distance = length_at(improver, bad, shortest),
                             .is_flat = is_flat};
  const auto found = find_split(improver.work, bad.tet, options);
  const bool is_split = found && found->new_worst >= least && apply(improver, *found);
  if (is_flat) {
    improver.count_attempts(attempts_of_flat);
    improver.failures_beside_flat += is_split ? failures_for_success : -1;
  }
  if (is_split) ++improver.report.splits;
  return is_split;
}

/// Collapses or splits a tet that is bad enough for any gain, or that can be made good.
bool rebuild(Improver& improver, const BadTet& bad) {
  const bool takes_any = bad.quality < improver.aims.rebuilt;
  if (!takes_any && !improver.options.rebuilds_to_wanted) return false;
  const double least = takes_any ? 0 : improver.aims.wanted;
  const double shortest = takes_any ? shortest_split : shortest_mild_split;
  return collapse(improver, bad, least) || split(improver, bad, shortest, least);
}

/// Whether something has changed since that the operations on the tet look at: the ball of a node
/// that may move, or what lies at one of its edges. A change elsewhere at a node of the surface,
/// which may have hundreds of tets, is none.
bool is_changed_near(const WorkMesh& work, const Tet& tet, std::int64_t since) {
  int changed = 0;
  for (const std::int32_t v : tet) {
    if (work.change_of(v) <= since) continue;
    if (work.may_move(v)) return true;
    ++changed;
  }
  return changed > 1;
}

/// A last resort: small cavities round the tets that were given up are searched for their best
/// filling. What gets better may give others room, so all operations are tried there once more.
void reconnect_worst(Improver& improver) {
  ReconnectionOptions options;
  options.enough = improver.aims.enough;
  for (const BadTet& bad : worst_given_up(improver, improver.aims.rebuilt)) {
    if (improver.attempts <= 0) return;
    if (!improver.is_current(bad)) continue;
    improver.count_attempts(attempts_of_reconnection);
    const auto found = find_reconnection(improver.work, bad.tet, options);
    if (!found || !apply(improver, *found)) continue;
    ++improver.report.reconnections;
    run_pass(improver, true);
  }
}

/// The very last resort, for the few that nothing helped.
void split_desperate(Improver& improver) {
  for (const BadTet& bad : worst_given_up(improver, quality_of_angle(desperate_deg))) {
    if (improver.attempts <= 0) return;
    if (!improver.is_current(bad)) continue;
    improver.count_attempts(1);
    if (split(improver, bad, shortest_near_split, 0)) run_pass(improver, true);
  }
}

}  // namespace

double length_at(const Improver& improver, const BadTet& bad, double spacings) {
  if (!improver.options.spacing) return 0;
  Vec3 centre;
  for (const std::int32_t v : improver.work.tet(bad.tet)) centre += 0.25 * improver.work.point(v);
  return spacings * improver.options.spacing(centre);
}

void begin_pass(const Improver& improver) {
  // What is queued says little: most tries queue others.
  improver.options.progress.begin(WorkStage::cosmetics, 0, tell_every);
  improver.options.progress.next_pass();
}

void run_pass(Improver& improver, bool thorough) {
  while (!improver.queue.empty() && improver.attempts > 0) {
    const BadTet bad = improver.queue.top();
    improver.queue.pop();
    improver.options.progress.add();
    if (!improver.is_current(bad)) continue;
    improver.count_attempts(1);
    if (swap(improver, bad) || smooth(improver, bad)) continue;
    if (thorough && rebuild(improver, bad)) continue;
    improver.given_up.push_back({bad, improver.work.changes});
  }
}

void requeue(Improver& improver, bool thorough) {
  std::vector<GivenUp> kept;
  for (const GivenUp& item : improver.given_up) {
    if (!improver.is_current(item.bad)) continue;
    const bool changed =
        is_changed_near(improver.work, improver.work.tet(item.bad.tet), item.changes);
    const bool rebuildable =
        item.bad.quality < improver.aims.rebuilt || improver.options.rebuilds_to_wanted;
    if (changed || (thorough && rebuildable)) {
      improver.queue.push(item.bad);
    } else {
      kept.push_back(item);
    }
  }
  improver.given_up = std::move(kept);
}

std::vector<BadTet> worst_given_up(const Improver& improver, double below) {
  std::vector<BadTet> worst;
  for (const GivenUp& item : improver.given_up) {
    if (improver.is_current(item.bad) && item.bad.quality < below) worst.push_back(item.bad);
  }
  std::sort(worst.begin(), worst.end(), [](const BadTet& a, const BadTet& b) { return b < a; });
  return worst;
}

void try_last_resorts(Improver& improver) {
  reconnect_worst(improver);
  split_desperate(improver);
}

}  // namespace tetfarm::cosmetics
