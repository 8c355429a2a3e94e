/// Draws a mesh of the plane: its triangles, a field at its nodes as filled contours, metrics as
/// ellipses; always with its boundary and numbers along the frame.
///
/// Source: the pictures of chapter 3 of the thesis: meshes, solutions on them, and metrics (figs.
/// 19 to 30 and 38 to 44). Within a triangle a field is linear, as the mesh has it, so that its
/// contours are straight lines there.
/// Memory: 20 bytes a pixel, and some 50 for each edge that is drawn. Cost: O(n log n), and the
/// samples of the pixels.
#pragma once

#include <array>
#include <optional>
#include <span>

#include "mesh/metric/metric2.h"
#include "mesh/planar/plane_mesh.h"
#include "mesh/render/picture.h"
#include "mesh/render/plane_frame.h"

namespace tetfarm {

/// What is drawn on a mesh, by its nodes; either may be empty.
struct PlaneContents {
  std::span<const double> field;
  std::span<const Metric2> metrics;
};

struct PlanePictureOptions {
  int width = 1600;
  int height = 1000;
  int samples = 3;          ///< along a pixel's side
  double edge_width = 0.9;  ///< of the triangles' edges, in pixels; 0: none
  PlaneWindow window;
  int levels = 20;                             ///< bands of the field
  std::optional<std::array<double, 2>> range;  ///< of the bands; nothing: that of the field
};

/// @pre contents have a finite value, or a metric, for each node, or are empty.
/// @throws InvalidInput with the number and place of what is no triangle or edge of the mesh;
/// UsageError when a range or a window is empty.
Picture plane_picture(const PlaneMesh& mesh, const PlaneContents& contents,
                      const PlanePictureOptions& options);

/// @throws InvalidInput when a triangle or an edge names a node that there is not.
void require_nodes_of_mesh(const PlaneMesh& mesh);

}  // namespace tetfarm
