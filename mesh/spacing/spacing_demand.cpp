#include "mesh/spacing/spacing_demand.h"

#include <algorithm>
#include <numeric>

namespace tetfarm {

bool SpacingDemand::grows_too_fast() const {
  return background_mesh.has_value() ||
         std::ranges::any_of(sources, [](const SourceDemand& s) { return s.varies; });
}

CellDemand::CellDemand(const SpacingDemand& demand) : demand_(demand), starts_{0} {
  sources_.resize(demand.sources.size());
  std::iota(sources_.begin(), sources_.end(), 0U);
}

std::span<const std::uint32_t> CellDemand::sources_here() const {
  return std::span(sources_).subspan(starts_.back());
}

void CellDemand::enter(const Cell& cell) {
  const std::size_t begin = starts_.back();
  const std::size_t end = sources_.size();
  starts_.push_back(end);
  cells_.push_back(cell);
  double limit = demand_.ceiling;
  for (std::size_t k = begin; k < end; ++k) {
    const SourceDemand& source = demand_.sources[sources_[k]];
    const double asked =
        source_value(source, cell.centre, 0, demand_.background, demand_.growth).asked;
    limit = std::min(limit, asked + demand_.growth * cell.half_diagonal);
  }
  for (std::size_t k = begin; k < end; ++k) {
    const SourceDemand& source = demand_.sources[sources_[k]];
    const SourceValue value =
        source_value(source, cell.centre, cell.half_diagonal, demand_.background, demand_.growth);
    if (value.floor <= limit && value.floor < demand_.ceiling) sources_.push_back(sources_[k]);
  }
}

void CellDemand::leave() {
  sources_.resize(starts_.back());
  starts_.pop_back();
  cells_.pop_back();
}

CellDemand::Bounds CellDemand::bounds() const {
  const Cell& cell = cells_.back();
  Bounds bounds;
  bounds.at_centre = at(cell.centre);
  bounds.lowest = demand_.ceiling;
  for (const std::uint32_t source : sources_here()) {
    const SourceValue value = source_value(demand_.sources[source], cell.centre, cell.half_diagonal,
                                           demand_.background, demand_.growth);
    bounds.lowest = std::min(bounds.lowest, value.floor);
  }
  bounds.lowest = demand_.points.lowest(cell.centre, cell.half_diagonal, bounds.lowest);
  bounds.is_ceiling = !demand_.background_mesh && bounds.lowest >= demand_.ceiling;
  return bounds;
}

double CellDemand::at(const Vec3& point) const {
  double spacing = demand_.ceiling;
  for (const std::uint32_t source : sources_here()) {
    const SourceValue value =
        source_value(demand_.sources[source], point, 0, demand_.background, demand_.growth);
    spacing = std::min(spacing, value.asked);
  }
  if (demand_.background_mesh) spacing = std::min(spacing, demand_.background_mesh->at(point));
  return demand_.points.lowest(point, 0, spacing);
}

}  // namespace tetfarm
