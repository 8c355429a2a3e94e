#include "mesh/cosmetics/bad_tets.h"

#include <algorithm>
#include <limits>

#include "base/array_index.h"
#include "base/check.h"
#include "mesh/cosmetics/quality.h"
#include "mesh/cosmetics/smallest_angle.h"

namespace tetfarm::cosmetics {

BadTetScan scan_for_bad_tets(const TetComplex& complex, const QualityLimits& limits,
                             const CosmeticOptions& options) {
  const RegularTets& regular = options.regular;
  TF_CHECK(options.regular.first <= options.regular.last);
  constexpr double quality_of_regular = 0.75;
  const bool skips_regular = std::max(limits.wanted, limits.relaxed) < quality_of_regular;
  BadTetScan result;
  SmallestAngle smallest;
  result.tet2quality.assign(complex.nodes.size(), std::numeric_limits<double>::quiet_NaN());
  for (std::int32_t t = 0; at(t) < complex.nodes.size(); ++t) {
    if (!complex.is_live(t) || (skips_regular && regular.holds(t) && t != regular.first)) continue;
    const Tet& tet = complex.nodes[at(t)];
    const double now = quality(complex, tet);
    result.tet2quality[at(t)] = now;
    if (now < limits.wanted) result.bad.push_back({now, t});
    if (now < limits.relaxed) {
      if (result.to_relax.empty()) result.to_relax.resize(complex.points.size());
      for (const std::int32_t v : tet) result.to_relax[at(v)] = true;
    }
    if (options.measures_angles) smallest.add(complex, tet, now);
  }
  if (options.measures_angles) result.min_dihedral_deg = smallest.degrees();
  return result;
}

double min_dihedral_deg(const WorkMesh& work, const RegularTets& regular) {
  SmallestAngle smallest;
  for (std::int32_t t = 0; at(t) < work.complex.nodes.size(); ++t) {
    if (!work.complex.is_live(t)) continue;
    if (regular.holds(t) && t != regular.first && work.is_untouched(t)) continue;
    smallest.add(work.complex, work.tet(t), work.quality_of(t));
  }
  return smallest.degrees();
}

}  // namespace tetfarm::cosmetics
