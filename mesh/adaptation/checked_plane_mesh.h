/// From the mesh of a file to the working mesh: checked, with its boundary as curves and corners.
///
/// A corner is a node where boundary edges of two patches meet, or other than two, or two that turn
/// by more than an angle; between corners the edges of a patch are one curve through their nodes.
/// Edges between triangles of two regions are held like those of the boundary.
/// Determinism: curves are numbered in the order of their first edges in the complex.
#pragma once

#include <span>
#include <string>

#include "mesh/adaptation/metric_mesh.h"
#include "mesh/planar/plane_mesh.h"

namespace tetfarm {

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

/// @pre checked. @throws InvalidInput when an edge of the mesh is no edge of a triangle.
MetricMesh make_metric_mesh(const PlaneMesh& mesh, const TriangleComplex& complex,
                            std::span<const Metric2> metrics, double corner_angle_deg);

/// What is in use, with the nodes in the order in which the triangles, sorted along the Hilbert
/// curve, name them.
struct MeshWithMetrics {
  PlaneMesh mesh;
  std::vector<Metric2> metrics;
};
MeshWithMetrics plane_mesh_of(const MetricMesh& mesh);

}  // namespace tetfarm
