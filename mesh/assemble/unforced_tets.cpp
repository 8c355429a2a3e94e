#include "mesh/assemble/unforced_tets.h"

#include <algorithm>

#include "base/array_index.h"
#include "base/check.h"
#include "mesh/core/tet_quality.h"

namespace tetfarm {

UnforcedTets unforced_tets(const Portion& portion, const std::vector<bool>& is_forced) {
  TF_CHECK(std::ssize(portion.part.tets) == portion.tets);
  TF_CHECK(is_forced.size() <= portion.part.nodes.size());
  const ShapeStatistics& all = portion.shapes.all;
  if (std::find(is_forced.begin(), is_forced.end(), true) == is_forced.end()) {
    return {all.tets, all.min_dihedral_deg, all.worst_centroid};
  }
  const auto node = [&portion](std::int32_t v) -> const Vec3& { return portion.part.nodes[at(v)]; };
  const auto forced = [&is_forced](std::int32_t v) {
    return at(v) < is_forced.size() && is_forced[at(v)];
  };
  UnforcedTets result;
  for (const Tet& tet : portion.part.tets) {
    if (std::any_of(tet.begin(), tet.end(), forced)) continue;
    ++result.tets;
    const auto& [a, b, c, d] = tet;
    const double angle = dihedral_range(node(a), node(b), node(c), node(d)).min_deg;
    if (angle >= result.min_dihedral_deg) continue;
    result.min_dihedral_deg = angle;
    result.worst_centroid = 0.25 * (node(a) + node(b) + node(c) + node(d));
  }
  return result;
}

}  // namespace tetfarm
