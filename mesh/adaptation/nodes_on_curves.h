/// Puts the nodes of patches on the true curves of these, before a mesh is adapted: each to the
/// nearest place, if that is near enough.
///
/// Nodes at corners of a curve, such as a trailing edge, become corners of the mesh; a node where
/// several curves meet goes to where they cross. Source: none (the thesis leaves the curve,
/// 3.3.3.4). Cost: O(nodes of the patches · samples of their curves), and O(triangles).
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "mesh/adaptation/patch_curve.h"
#include "mesh/planar/plane_mesh.h"
#include "mesh/planar/triangle_complex.h"

namespace tetfarm {

/// What became of the nodes of one curve.
struct MovedNodes {
  std::int64_t nodes = 0;
  std::int64_t moved = 0;
  double farthest = 0;     ///< how far one was moved at most
  std::int32_t node = -1;  ///< that one; -1: none was
};

struct NodesOnCurves {
  PlaneMesh mesh;
  std::vector<MovedNodes> moved;  ///< of each curve
};

/// The nodes of the patches, ascending. `complex`: checked_complex() of the mesh.
/// @throws InvalidInput when there is no such patch, naming those that there are.
std::vector<std::int32_t> nodes_of_patches(const PlaneMesh& mesh, const TriangleComplex& complex,
                                           const std::vector<std::int32_t>& patches,
                                           const std::string& name);

/// `complex`: checked_complex() of the mesh.
/// @throws InvalidInput with the node, its place and its distance when one lies further from its
/// curve than a thousandth of the edges there; when nodes do not follow one another on the curve;
/// when a triangle would turn over; when curves of neighbouring patches do not meet.
NodesOnCurves put_on_curves(const PlaneMesh& mesh, const TriangleComplex& complex,
                            std::span<const PatchCurve> curves, double corner_angle_deg);

}  // namespace tetfarm
