#include "mesh/spacing/spacing_demand.h"

#include <algorithm>
#include <numeric>

namespace tetfarm {

CellDemand::CellDemand(const SpacingDemand& demand) : demand_(demand), starts_{0} {
  sources_.resize(demand.sources.size());
  std::iota(sources_.begin(), sources_.end(), 0U);
}

SourceValue CellDemand::source_at(std::uint32_t source, const Vec3& point) const {
  return source_value(demand_.sources[source], point, demand_.background, demand_.growth);
}

CellDemand::Bounds CellDemand::enter(const Cell& cell) {
  const double change = demand_.growth * cell.half_diagonal;
  const double nobody = demand_.ceiling + change;
  const std::size_t start = starts_.back();
  const std::size_t count = sources_.size() - start;
  floors_.resize(count);
  double asked = nobody;
  double floor = nobody;
  for (std::size_t k = 0; k < count; ++k) {
    const SourceValue here = source_at(sources_[start + k], cell.centre);
    floors_[k] = here.floor;
    asked = std::min(asked, here.asked);
    floor = std::min(floor, here.floor);
  }
  asked = demand_.points.at(cell.centre, asked);
  floor = std::min(floor, asked);
  const double limit = std::min(asked + 2 * change, nobody);
  starts_.push_back(sources_.size());
  for (std::size_t k = 0; k < count; ++k) {
    if (floors_[k] < limit) sources_.push_back(sources_[start + k]);
  }
  return {std::min(asked, demand_.ceiling), floor - change, floor >= nobody};
}

void CellDemand::leave() {
  sources_.resize(starts_.back());
  starts_.pop_back();
}

double CellDemand::at(const Vec3& point) const {
  double spacing = demand_.ceiling;
  for (std::size_t k = starts_.back(); k < sources_.size(); ++k) {
    spacing = std::min(spacing, source_at(sources_[k], point).asked);
  }
  return demand_.points.at(point, spacing);
}

}  // namespace tetfarm
