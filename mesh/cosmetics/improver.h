/// The operations of cosmetics on single bad tets, and passes of them, worst first.
///
/// Source: thesis 4.3.4.1; orders and bounds are of docs/decisions/0007-cosmetics-measure.md. Cost:
/// counted in attempts, each of which is some 20 to 40 µs; a pass ends when they are spent.
#pragma once

#include <cstdint>
#include <limits>
#include <queue>
#include <vector>

#include "base/array_index.h"
#include "mesh/cosmetics/bad_tets.h"
#include "mesh/cosmetics/cavity.h"
#include "mesh/cosmetics/improve_mesh.h"

namespace tetfarm::cosmetics {

/// A node that a last resort puts near to others keeps this many spacings from them.
inline constexpr double shortest_near_split = 0.1;

/// Searches for places beside flat tets that may fail at first.
inline constexpr std::int64_t most_failures_beside_flat = 300;

/// The quality below which tets are worked on, the one below which swaps and moves are not all,
/// and the one beyond which no operation is sought.
struct Aims {
  double wanted = 0;
  double rebuilt = 0;
  double enough = 0;
};

/// A bad tet that nothing helped, and the number of changes made until then.
struct GivenUp {
  BadTet bad;
  std::int64_t changes;
};

struct Improver {
  WorkMesh work;
  const CosmeticOptions& options;
  Aims aims;
  CosmeticReport report;
  std::priority_queue<BadTet> queue;
  std::vector<GivenUp> given_up;
  /// Number of changes when no better place was found for a node; until its ball changes there is
  /// none.
  std::vector<std::int64_t> node2settled;
  /// How many more tets may be tried.
  std::int64_t attempts = std::numeric_limits<std::int64_t>::max();
  /// How many more searches for places beside flat tets may fail; each that finds one adds some.
  std::int64_t failures_beside_flat = most_failures_beside_flat;

  void count_attempts(std::int64_t n) {
    attempts -= n;
    report.attempts += n;
  }
  bool is_settled(std::int32_t node) const {
    return at(node) < node2settled.size() && node2settled[at(node)] >= work.node2change[at(node)];
  }
  void settle(std::int32_t node) {
    if (at(node) >= node2settled.size()) node2settled.resize(work.node2change.size(), -1);
    node2settled[at(node)] = work.changes;
  }
  void queue_bad(const std::vector<std::int32_t>& tets) {
    for (const std::int32_t t : tets) {
      const double now = work.quality_of(t);
      if (now < aims.wanted) queue.push({now, t});
    }
  }
  bool is_current(const BadTet& bad) const {
    return work.complex.is_live(bad.tet) && work.quality_of(bad.tet) == bad.quality;
  }

 private:
};

/// Tells that a pass begins.
void begin_pass(const Improver& improver);

/// Works the queue off, worst first. Collapses and splits change the number of nodes and cost most,
/// so they wait for a `thorough` pass, when swaps and moves have done what they can.
void run_pass(Improver& improver, bool thorough);

/// Queues again the tets that were given up, when something near them has changed since, or when
/// the next pass is the first `thorough` one and may do more for them.
void requeue(Improver& improver, bool thorough);

/// The tets that were given up below this quality, worst first.
std::vector<BadTet> worst_given_up(const Improver& improver, double below);

/// As many spacings as that, at the centre of the tet; 0 when none are known.
double length_at(const Improver& improver, const BadTet& bad, double spacings);

/// For what was given up: small cavities are filled anew in the best way; then nodes are put near
/// to others.
void try_last_resorts(Improver& improver);

}  // namespace tetfarm::cosmetics
