/// A triangulated domain of the plane as files hold it: with its boundary, patches and regions.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "mesh/geometry/predicates.h"

namespace tetfarm {

/// Triangles anticlockwise. `edges` are those of the boundary and any inside that have to stay;
/// numbers of patches and regions are the file's own.
struct PlaneMesh {
  std::string name;  ///< of the file, for messages; may be empty
  std::vector<Vec2> points;
  std::vector<std::array<std::int32_t, 3>> triangles;
  std::vector<std::int32_t> regions;  ///< a number for each triangle
  std::vector<std::array<std::int32_t, 2>> edges;
  std::vector<std::int32_t> patches;  ///< a number for each edge
  std::vector<std::int32_t> corners;  ///< points that stay where they are
  /// Of those that have one, by number.
  std::map<std::int32_t, std::string> patch_names;
  std::map<std::int32_t, std::string> region_names;
};

}  // namespace tetfarm
