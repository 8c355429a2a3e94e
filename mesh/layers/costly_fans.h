/// Fans that cost more layers than they are worth: beside one whose cells fold low, the lines all
/// round have fewer layers than with single lines there.
///
/// Source: none; a fan has many lines close together, and where edges are far shorter than the
/// layers are high, as at the tip of a wing whose trailing edge ends there, they have no room.
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/core/surface_mesh.h"
#include "mesh/layers/layer_plan.h"

namespace tetfarm {

/// A place where cells fold or the top crosses something, with fans near it.
struct CostlyFans {
  std::vector<std::int32_t> fans;  ///< feet of several lines near the place, ascending
  std::vector<std::int32_t> held;  ///< feet with fewer layers because of it, ascending
};

/// Those of the plan, by the place. Near are feet at most so many edges away. Cost: O(n log n).
std::vector<CostlyFans> costly_fans(const LayerPlan& plan, const SurfaceMesh& surface, int edges);

/// How many layers are missing at the feet, each counted by its lowest line. Cost: O(feet).
std::int64_t missing_layers_at(const LayerPlan& plan, const std::vector<std::int32_t>& feet);

/// The same of all feet.
std::int64_t missing_layers(const LayerPlan& plan);

}  // namespace tetfarm
