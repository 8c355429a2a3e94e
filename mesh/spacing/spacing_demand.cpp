#include "mesh/spacing/spacing_demand.h"

#include <algorithm>
#include <numeric>

#include "base/check.h"

namespace tetfarm {
namespace {

/// What one source costs, in looks at a point's demand.
constexpr std::size_t looks_of_source = 8;

}  // namespace

bool SpacingDemand::grows_too_fast() const {
  return std::ranges::any_of(sources, [](const SourceDemand& s) { return s.varies; });
}

CellDemand::CellDemand(const SpacingDemand& demand)
    : demand_(demand),
      points_(demand.points),
      starts_{0},
      grows_too_fast_(demand.grows_too_fast()) {
  sources_.resize(demand.sources.size());
  std::iota(sources_.begin(), sources_.end(), 0U);
}

std::span<const std::uint32_t> CellDemand::sources_here() const {
  return std::span(sources_).subspan(starts_.back());
}

void CellDemand::note_look() const {
  looked_at_ += 1 + looks_of_source * sources_here().size() + points_.listed();
}

void CellDemand::enter(const Cell& cell) {
  note_look();
  const std::size_t begin = starts_.back();
  const std::size_t end = sources_.size();
  starts_.push_back(end);
  cells_.push_back(cell);
  points_.enter(cell.centre, cell.half_diagonal, demand_.ceiling);
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
  TF_CHECK(starts_.size() > 1);
  points_.leave();
  sources_.resize(starts_.back());
  starts_.pop_back();
  cells_.pop_back();
}

CellDemand::Bounds CellDemand::bounds(double enough) const {
  note_look();
  TF_CHECK(!cells_.empty());
  const Cell& cell = cells_.back();
  const double at_centre = at(cell.centre);
  if (!grows_too_fast_ && at_centre < demand_.ceiling) {
    const double by_growth = at_centre - demand_.growth * cell.half_diagonal;
    if (by_growth >= enough) return {at_centre, by_growth, false};
  }
  double lowest = demand_.ceiling;
  for (const std::uint32_t source : sources_here()) {
    const SourceValue value = source_value(demand_.sources[source], cell.centre, cell.half_diagonal,
                                           demand_.background, demand_.growth);
    lowest = std::min(lowest, value.floor);
  }
  lowest = points_.lowest(cell.centre, cell.half_diagonal, lowest);
  lowest = demand_.triangles.lowest(cell.centre, cell.half_diagonal, lowest);
  return {at_centre, lowest, lowest >= demand_.ceiling};
}

double CellDemand::at(const Vec3& point) const {
  note_look();
  double spacing = demand_.ceiling;
  for (const std::uint32_t source : sources_here()) {
    const SourceValue value =
        source_value(demand_.sources[source], point, 0, demand_.background, demand_.growth);
    spacing = std::min(spacing, value.asked);
  }
  return demand_.triangles.lowest(point, 0, points_.lowest(point, 0, spacing));
}

}  // namespace tetfarm
