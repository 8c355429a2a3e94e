/// Cuts a sub-domain in two with a nearly planar inter-domain mesh (thesis 4.3.1, fig. 48).
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/work_progress.h"
#include "mesh/core/subdomain.h"
#include "mesh/decompose/cut_plane.h"
#include "mesh/spacing/spacing_field.h"

namespace tetfarm {

struct CutOptions {
  CutPlanes planes = CutPlanes::automatic;
  /// Stop at the first candidate that meets the surface at no smaller angle than this. The next
  /// angle counts when no candidate near the wanted share passes; candidates far from it come one
  /// angle later.
  std::vector<double> smallest_angles_deg = {40, 30, 20};
  int candidates = 36;
  /// The work wanted on the left, as a share of the whole.
  double left_share = 0.5;
  /// A last check of a cut that passed all others; refused cuts are followed by the next candidate.
  /// Gets the two halves. Empty: accept. Must be deterministic.
  std::function<bool(const Subdomain& left, const Subdomain& right)> accept;
  int most_accept_calls = 6;
  /// Counts the candidates that were tried.
  WorkProgress progress = {};
};

struct Cut {
  Subdomain left;
  Subdomain right;
  std::int32_t interdomain_triangles = 0;
  double smallest_angle_deg = 0;
  double left_work = 0;
  double right_work = 0;
  int candidates_tried = 0;
  /// Why those before it were refused, with counts; empty when it was the first.
  std::string refused;
};

/// Either a cut, or why there is none: the sub-domain then stays a leaf.
struct CutOutcome {
  std::optional<Cut> cut;
  std::string reason;
};

/// Each inter-domain triangle is stored once, oriented out of the left side; the right reads it
/// reversed. Its nodes and triangles get Origin{owner = subdomain.path.heap, index}. Both halves
/// hold validate(). Deterministic. Cost: O(n log n) a candidate.
CutOutcome planar_cut(const Subdomain& subdomain, const SpacingField& spacing,
                      const CutOptions& options = {});

/// Enough lattice nodes for an estimate that is shown.
inline constexpr std::size_t samples_for_counting = 40000;

/// Estimated elements: ∫ elements_per_h3 / h^3 dV over the inside (thesis counts boundary faces; a
/// departure: work is known, so it is computed). Cost: O(n log n).
double estimated_elements(const Subdomain& subdomain, const SpacingField& spacing,
                          std::size_t samples = samples_for_counting);

}  // namespace tetfarm
