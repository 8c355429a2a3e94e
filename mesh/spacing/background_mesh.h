/// The background mesh: tets that connect the source points, with the spacing linear in each.
///
/// Source: thesis 4.3.1.9 and figure 62 (Bowyer-Watson on the box of the domain, then the sources).
/// The box's corners carry the background, so a background mesh fills everything between two fine
/// sources, however far apart, with fine spacing: the thesis's pre-processor wants that, most users
/// of sources with an outer radius do not. It is therefore off unless
/// SpacingOptions::background_mesh.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "mesh/core/tet_complex.h"
#include "mesh/core/vec3.h"
#include "mesh/spacing/sources.h"

namespace tetfarm {

class BackgroundMesh {
 public:
  /// `box` holds every point to be asked; its corners get `background`. Values at the points are
  /// limited by the growth between any two of them.
  /// @pre background > 0; box is not flat. Cost: O(n^2) for n source corners.
  BackgroundMesh(const std::vector<SourceDemand>& sources, const Box3& box, double background,
                 double growth);

  /// The linear interpolant at a point of the box. Cost: a walk from the tet asked last.
  double at(const Vec3& point) const;

 private:
  std::unique_ptr<TetComplex> complex_;
  std::vector<double> spacing_;
  mutable std::int32_t last_tet_ = 0;
};

}  // namespace tetfarm
