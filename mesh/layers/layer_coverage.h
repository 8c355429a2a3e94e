/// How much of the wall has the layers that were asked for, and why the rest has not: for people.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "mesh/core/surface_mesh.h"
#include "mesh/layers/layer_plan.h"

namespace tetfarm {

/// What one triangle of the wall has.
struct WallLayers {
  std::int32_t triangle = 0;  ///< of the surface
  int layers = 0;             ///< that reach all over it: the least of its lines
  int cells = 0;              ///< above it: the most of its lines
  int wanted = 0;             ///< the most that one of its lines was asked for
  double first_height = 0;    ///< of its first prism, normal to it, the mean of its corners; or 0
  double first_wanted = 0;    ///< as was asked for
  double total_height = 0;    ///< of the prisms, in the same way
  StopReason reason = StopReason::complete;  ///< of the line with the fewest layers
  std::int32_t because_of = -1;              ///< the vertex where that is so; -1: nowhere
};

/// Of each wall triangle, in the order of the plan. Cost: O(n).
std::vector<WallLayers> wall_layers(const LayerPlan& plan, const SurfaceMesh& surface);

struct LayerCoverage {
  std::int64_t wall_triangles = 0;  ///< on which layers were asked for
  std::int64_t full = 0;            ///< of them with all layers above all of the triangle
  std::int64_t none = 0;            ///< without a cell above it
  std::map<StopReason, std::int64_t> short_of_layers;  ///< the others and `none`, by reason
  std::int64_t with_first = 0;                         ///< with a prism on them
  std::int64_t first_within_2 = 0;   ///< of these, whose height is as asked to 2 %
  std::int64_t first_within_10 = 0;  ///< to 10 %

  std::int64_t partial() const { return wall_triangles - full - none; }
  friend bool operator==(const LayerCoverage&, const LayerCoverage&) = default;
};

LayerCoverage coverage_of(const std::vector<WallLayers>& walls);

/// A map for people: the wall with what each triangle has, as the text of a .vtp file: `layers`,
/// `wanted`, `first_height`, `first_wanted`, `total_height`, `reason` (a number, told in the file's
/// first lines), `because_of` and `triangle`. @pre `walls` are of the plan and the surface. Cost:
/// O(n).
std::string layer_map_vtp(const std::vector<WallLayers>& walls, const LayerPlan& plan,
                          const SurfaceMesh& surface);

}  // namespace tetfarm
