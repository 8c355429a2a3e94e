#include "mesh/cosmetics/element_collapse.h"

#include <algorithm>

#include "base/check.h"
#include "mesh/cosmetics/quality.h"

namespace tetfarm::cosmetics {

std::optional<Replacement> find_collapse(const WorkMesh& work,
                                         const std::vector<std::int32_t>& ball, std::int32_t node,
                                         std::int32_t onto, double beat) {
  TF_CHECK(onto != node && work.may_move(node));
  const double before = worst_of(work, ball);
  Replacement replacement{ball, {}, before, 1, std::nullopt};
  for (const std::int32_t t : ball) {
    Tet tet = work.tet(t);
    if (std::find(tet.begin(), tet.end(), onto) != tet.end()) continue;
    std::replace(tet.begin(), tet.end(), node, onto);
    replacement.new_worst = std::min(replacement.new_worst, quality(work.complex, tet));
    if (replacement.new_worst <= beat || !is_worth(before, replacement.new_worst, work.gain)) {
      return std::nullopt;
    }
    replacement.new_tets.push_back(tet);
  }
  TF_CHECK(replacement.new_tets.size() < ball.size());
  return replacement;
}

}  // namespace tetfarm::cosmetics
