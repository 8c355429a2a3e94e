/// The edge length that remeshing wants at a point of the surface.
///
/// The least of the size asked for, the job's sources and sizes at patches, and what curvature and
/// narrow places demand, growing by no more than `growth` for each unit of length away from there.
/// Other than the spacing of the volume it is not put on an octree: it is asked for at single
/// points.
#pragma once

#include <memory>
#include <vector>

#include "mesh/remeshing/remesh_options.h"
#include "mesh/remeshing/surface_features.h"
#include "mesh/spacing/demand_tree.h"
#include "mesh/spacing/sources.h"
#include "mesh/spacing/triangle_demands.h"

namespace tetfarm {

class RemeshingSpacing {
 public:
  /// The same everywhere: for tests.
  explicit RemeshingSpacing(double everywhere);
  /// @pre the options have been through with_defaults. Cost: O(n log n).
  RemeshingSpacing(std::vector<PointDemand> demands, const RemeshOptions& options);

  /// Never more than size, and less than min_size only near short edges between corners, down to a
  /// sixteenth of it, and where a patch has a size that is less.
  /// Cost: O(log n) and the sources, about 1 µs.
  double at(const Vec3& point) const;
  /// A lower bound, where `there` is the spacing, of the spacing so far away. Cost: O(1).
  double least_near(double there, double away) const {
    // Sources may be steeper than the growth.
    return sources_.empty() ? there - growth_ * away : 0;
  }

 private:
  double size_ = 0;
  double min_size_ = 0;
  double growth_ = 0.3;
  std::unique_ptr<DemandTree> tree_;
  std::unique_ptr<DemandsInCell> demands_;  ///< of all space
  std::vector<SourceDemand> sources_;
  TriangleDemandTree triangles_;
};

/// @pre check_surface found no defect; the options have been through with_defaults.
/// Cost: that of curvature_demands and proximity_demands.
RemeshingSpacing remeshing_spacing(const SurfaceMesh& surface, const SurfaceFeatures& features,
                                   const RemeshOptions& options);

}  // namespace tetfarm
