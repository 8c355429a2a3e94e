/// Which of the regions that a surface divides space into are meshed, and what they are called.
///
/// Without a word from the job: an edge on more than two triangles means that the surface has
/// internal interfaces, and every region that it bounds is meshed. Otherwise regions are meshed or
/// not in turn, from the outermost shell inward. Under an outer boundary the outside is meshed and
/// what the body bounds is not, or, without interfaces, every second region inward again.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "mesh/core/surface_mesh.h"
#include "mesh/inspect/surface_report.h"

namespace tetfarm {

class RegionMap;

/// What the job says of the region round a point.
struct RegionWish {
  Vec3 at;
  std::string name;  ///< empty: "region N"
  bool is_void = false;
};

struct RegionRules {
  std::vector<RegionWish> wishes;
  /// There will be an outer boundary: the outside is region 1.
  bool is_outside_meshed = false;
};

/// Gives the surface its sides and region names, turns its triangles so that they point out of a
/// region (of two: of the one with the lower number), and fills report.regions. Returns a defect
/// when triangles have one region on both sides, or nothing is left to mesh.
/// @throws UsageError when a wish's point is on the surface, outside of all regions, or where
/// another's is.
std::optional<SurfaceDefect> choose_regions(const RegionMap& map, const RegionRules& rules,
                                            bool has_interfaces, SurfaceMesh& surface,
                                            SurfaceReport& report);

}  // namespace tetfarm
