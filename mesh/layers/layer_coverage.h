/// How much of the wall has the layers that were asked for, and why the rest has not: for people.
#pragma once

#include <cstdint>
#include <map>

#include "mesh/core/surface_mesh.h"
#include "mesh/layers/layer_plan.h"

namespace tetfarm {

struct LayerCoverage {
  std::int64_t wall_triangles = 0;  ///< on which layers were asked for
  std::int64_t full = 0;            ///< of them with all layers above all of the triangle
  std::int64_t none = 0;            ///< without a cell above it
  /// Lines that have fewer layers than were asked for, or the same but lower ones.
  std::map<StopReason, std::int64_t> short_lines;

  std::int64_t partial() const { return wall_triangles - full - none; }
  friend bool operator==(const LayerCoverage&, const LayerCoverage&) = default;
};

/// @pre `plan` is of `surface`. Cost: O(n).
LayerCoverage coverage_of(const LayerPlan& plan, const SurfaceMesh& surface);

}  // namespace tetfarm
