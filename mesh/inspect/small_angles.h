/// How many triangles of a surface have small angles, and which are the worst: they are faces of
/// every mesh of it, whose tets there have small angles too.
///
/// Source: none in the thesis. Units: degrees; lengths in the unit of the input.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "mesh/core/surface_mesh.h"

namespace tetfarm {

struct SmallAngle {
  std::int64_t triangle = 0;  ///< of the surface, from 0
  double angle_deg = 180;     ///< its smallest
  Vec3 at;                    ///< the middle of its shortest edge
  std::string patch;          ///< its name in printable ASCII; "" when the surface has none
};

struct SmallAngles {
  std::int64_t triangles = 0;
  double smallest_deg = 180;
  std::int64_t below_1_deg = 0;
  std::int64_t below_5_deg = 0;
  /// Of those below 5 degrees the smallest, at most worst_kept, the first of equals first.
  std::vector<SmallAngle> worst;
};

inline constexpr std::size_t worst_kept = 3;

/// @param left_out whether a triangle is left out of all but the number of triangles; empty: none
/// is. @pre the triangles' nodes are vertices. Cost: O(n).
SmallAngles small_angles(const SurfaceMesh& surface, const std::vector<bool>& left_out = {});

/// "37 of 2240 triangles have an angle below 5 deg, 12 of them below 1 deg; the smallest: triangle
/// 17 0.00022 deg near (1, 2, 3) in patch "wing"; …": empty when there is none below 5 degrees.
std::string small_angles_text(const SmallAngles& angles);

}  // namespace tetfarm
