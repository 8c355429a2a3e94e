/// From the mesh of a file to the working mesh: checked, with its boundary as curves and corners.
///
/// Between corners (curve_tracing.h) the edges of a patch are one curve: a part of the one given
/// for the patch, or the spline through their nodes.
/// Determinism: curves are numbered in the order of their first edges in the complex.
#pragma once

#include <span>
#include <string>

#include "mesh/adaptation/metric_mesh.h"
#include "mesh/adaptation/patch_curve.h"
#include "mesh/planar/plane_mesh.h"

namespace tetfarm {

/// "FILE: what"; without a file "what".
std::string in_file(const std::string& name, const std::string& what);
/// "(x, y)", for messages.
std::string place_text(const Vec2& p);

/// Triangles as the complex of the mesh, anticlockwise whatever way they were given; points that no
/// triangle uses keep their numbers.
/// @throws InvalidInput with number and place of what is wrong: a number out of range, a triangle
/// without area, an edge of three triangles, coordinates that are no numbers.
TriangleComplex checked_complex(const PlaneMesh& mesh);

/// @throws InvalidInput when a number is not finite or is 1e100 or more in size, or when there are
/// not as many as points. `name`: of their file, for messages.
void check_values(const PlaneMesh& mesh, std::span<const double> values, const std::string& name);

/// @throws InvalidInput when a metric is not finite or not positive definite, or their number is
/// not that of the points. `name`: of their file, for messages.
void check_metrics(const PlaneMesh& mesh, std::span<const Metric2> metrics,
                   const std::string& name = "");

/// @pre checked; the nodes of patches with a curve lie on it (nodes_on_curves.h). @throws
/// InvalidInput when an edge of the mesh is no edge of a triangle.
MetricMesh make_metric_mesh(const PlaneMesh& mesh, const TriangleComplex& complex,
                            std::span<const Metric2> metrics, double corner_angle_deg,
                            std::span<const PatchCurve> curves = {});

/// What is in use, with the nodes in the order in which the triangles, sorted along the Hilbert
/// curve, name them.
struct MeshWithMetrics {
  PlaneMesh mesh;
  std::vector<Metric2> metrics;
};
MeshWithMetrics plane_mesh_of(const MetricMesh& mesh);

}  // namespace tetfarm
