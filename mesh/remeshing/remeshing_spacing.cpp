#include "mesh/remeshing/remeshing_spacing.h"

#include <algorithm>
#include <utility>

#include "mesh/remeshing/curvature_demands.h"
#include "mesh/remeshing/proximity_demands.h"

namespace tetfarm {

RemeshingSpacing::RemeshingSpacing(double everywhere) : size_(everywhere), min_size_(everywhere) {}

RemeshingSpacing::RemeshingSpacing(std::vector<PointDemand> demands, const RemeshOptions& options)
    : size_(options.size),
      min_size_(options.min_size),
      growth_(options.growth),
      triangles_(options.triangles) {
  std::erase_if(demands, [&](const PointDemand& demand) { return demand.spacing >= size_; });
  if (!demands.empty()) {
    tree_ = std::make_unique<DemandTree>(std::move(demands), growth_);
    demands_ = std::make_unique<DemandsInCell>(*tree_);
  }
  for (const Source& source : options.sources) {
    sources_.push_back(source_demand(source, growth_));
  }
}

double RemeshingSpacing::at(const Vec3& point) const {
  double wanted = size_;
  for (const SourceDemand& source : sources_) {
    wanted = std::min(wanted, source_value(source, point, 0, size_, growth_).asked);
  }
  wanted = triangles_.lowest(point, 0, std::max(wanted, min_size_));
  return demands_ ? demands_->lowest(point, 0, wanted) : wanted;
}

RemeshingSpacing remeshing_spacing(const SurfaceMesh& surface, const SurfaceFeatures& features,
                                   const RemeshOptions& options) {
  std::vector<PointDemand> demands = curvature_demands(surface, features, options);
  const std::vector<PointDemand> near = proximity_demands(surface, features, options);
  demands.insert(demands.end(), near.begin(), near.end());
  return RemeshingSpacing(std::move(demands), options);
}

}  // namespace tetfarm
