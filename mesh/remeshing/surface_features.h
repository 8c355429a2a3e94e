/// What remeshing keeps of a surface: its sharp edges, the borders of its patches and regions, and
/// its corners.
///
/// Source: X. Jiao and M. T. Heath, "Feature detection for surface meshes" (2002), of which the
/// angle between normals and the turning of curves are taken. A needle's own normal says little:
/// across an edge it counts as its neighbour over its longest edge does, and so on.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "mesh/core/surface_mesh.h"

namespace tetfarm {

enum class VertexKind : std::uint8_t { smooth, on_curve, corner };

struct SurfaceFeatures {
  std::vector<std::array<std::int32_t, 2>> edges;  ///< low < high, sorted, each once
  std::vector<VertexKind> kind;                    ///< of each vertex
  /// Of each triangle: a face is what is connected over edges that are no features. From 0, by
  /// first triangle.
  std::vector<std::int32_t> face;
  std::int32_t face_count = 0;
};

/// Features are edges whose triangles are not two, or differ in patch or regions, or whose normals
/// differ by more than `angle_deg`. A corner is a vertex where other than two of them meet, or
/// where two turn by more than that; without features, one round which a normal differs by more
/// from their mean.
/// @pre check_surface found no defect; angle_deg in (0, 180). Cost: O(n log n).
SurfaceFeatures surface_features(const SurfaceMesh& surface, double angle_deg);

}  // namespace tetfarm
