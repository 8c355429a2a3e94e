/// What a remeshed surface is like, and how far it is from its input.
///
/// Units: degrees, lengths in the unit of the input. "Free" are triangles without a vertex on a
/// feature: nothing but the spacing forces their shape.
#pragma once

#include <cstdint>

#include "mesh/remeshing/remesh.h"

namespace tetfarm {

struct FarthestPoint {
  double distance = 0;
  Vec3 at;
};

struct RemeshingFigures {
  std::int64_t triangles_before = 0;
  std::int64_t triangles = 0;
  std::int64_t vertices = 0;
  double smallest_angle_before_deg = 180;
  double smallest_angle_deg = 180;
  Vec3 smallest_at;  ///< a corner of that triangle
  std::int64_t below_20_deg = 0;
  std::int64_t below_30_deg = 0;
  std::int64_t free_triangles = 0;
  double smallest_free_angle_deg = 180;
  std::int64_t free_below_30_deg = 0;
  double mean_radius_ratio = 0;  ///< 2 inradius / circumradius: 1 of equilateral triangles
  double mean_length = 0;        ///< of edges over the spacing at their middle
  double well_sized = 0;         ///< share of edges from 0.6 to 1.5 of it
  FarthestPoint from_input;      ///< of the result, from the input
  FarthestPoint to_input;        ///< of the input, from the result
  double volume_before = 0;
  double volume = 0;
};

/// Distances are those of points: vertices, and some 20 for each triangle, evenly spread, 2 million
/// of a surface at most. Cost: O((n + points) log n).
RemeshingFigures remeshing_figures(const SurfaceMesh& input, const RemeshedSurface& result,
                                   const RemeshingSpacing& spacing);

}  // namespace tetfarm
