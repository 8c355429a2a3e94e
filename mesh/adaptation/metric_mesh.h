/// The mesh while it is adapted: triangles with a metric at each node, and what holds the boundary.
///
/// Lengths of edges and shapes of triangles are measured by the metrics of their nodes alone; the
/// metrics come from the background (MetricField) when a node is made or moved.
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <unordered_map>
#include <vector>

#include "base/array_index.h"
#include "mesh/adaptation/boundary_curve.h"
#include "mesh/adaptation/metric_field.h"
#include "mesh/metric/metric2.h"
#include "mesh/planar/triangle_complex.h"

namespace tetfarm {

/// A piece of boundary (or of a line inside) between two corners.
struct MeshCurve {
  BoundaryCurve shape;
  std::int32_t patch = 0;
};

/// Invariants: those of TriangleComplex for the triangles in use; 2. constrained edges are those of
/// `curve_of_edge`; 3. a node with curve >= 0 lies at its parameter.
struct MetricMesh {
  static constexpr std::int32_t inside = -1;  ///< for curve_of_node: on no curve
  static constexpr std::int32_t corner = -2;  ///< never moves, never goes

  TriangleComplex complex;
  std::vector<std::int32_t> regions;  ///< of each triangle
  std::vector<std::int32_t> unused;   ///< triangles that are none; their first node is -1

  std::vector<Metric2> metrics;
  std::vector<double> densities;            ///< square roots of the determinants
  std::vector<std::int32_t> homes;          ///< triangles of the background
  std::vector<std::int32_t> curve_of_node;  ///< number of a curve, `inside` or `corner`
  std::vector<double> parameters;           ///< on that curve
  std::vector<std::uint8_t> active;         ///< near something that changed, or is to be mended

  std::vector<MeshCurve> curves;
  std::unordered_map<std::uint64_t, std::int32_t> curve_of_edge;

  std::int32_t nodes() const { return static_cast<std::int32_t>(complex.points.size()); }
  bool is_used(std::int32_t triangle) const { return complex.node(triangle, 0) >= 0; }
  bool is_inside(std::int32_t node) const {
    return curve_of_node[static_cast<std::size_t>(node)] == inside;
  }
};

std::uint64_t edge_key(std::int32_t a, std::int32_t b);
/// -1 when the edge is on none.
std::int32_t curve_of_edge(const MetricMesh& mesh, std::int32_t a, std::int32_t b);
/// The parameter of a node of the curve, or of one of its corners; of a corner where the curve
/// begins and ends, the one nearer to `near`.
double parameter_on(const MetricMesh& mesh, std::int32_t curve, std::int32_t node, double near);

/// Where a node is, and the metric there.
struct NodePlace {
  Vec2 point;
  Metric2 metric;
  std::int32_t home = 0;
};

std::int32_t add_node(MetricMesh& mesh, const NodePlace& place);
void move_node(MetricMesh& mesh, std::int32_t node, const NodePlace& place);
inline NodePlace place_of(const MetricMesh& mesh, std::int32_t node) {
  return {mesh.complex.point(node), mesh.metrics[at(node)], mesh.homes[at(node)]};
}
/// A triangle to be overwritten.
std::int32_t take_triangle(MetricMesh& mesh);
void drop_triangle(MetricMesh& mesh, std::int32_t triangle);

/// The metric length of the edge between two nodes.
inline double edge_length(const MetricMesh& mesh, std::int32_t a, std::int32_t b) {
  const Vec2& p = mesh.complex.point(a);
  const Vec2& q = mesh.complex.point(b);
  return length_between({q.x - p.x, q.y - p.y}, mesh.metrics[at(a)], mesh.metrics[at(b)]);
}
/// The same from a place to a node.
inline double edge_length(const MetricMesh& mesh, const NodePlace& place, std::int32_t node) {
  const Vec2& q = mesh.complex.point(node);
  return length_between({q.x - place.point.x, q.y - place.point.y}, place.metric,
                        mesh.metrics[at(node)]);
}

/// How far a triangle is from an equilateral one of unit edges, by the mean of the metrics of its
/// nodes: the symmetric Dirichlet energy |J|² + |J⁻¹|² of the map from that triangle, 4 when equal;
/// infinite when it does not turn anticlockwise.
inline double triangle_energy(const Vec2& a, const Vec2& b, const Vec2& c, const Metric2& mean) {
  const Vec2 u{b.x - a.x, b.y - a.y};
  const Vec2 v{c.x - a.x, c.y - a.y};
  const Vec2 w{c.x - b.x, c.y - b.y};
  const double doubled = u.x * v.y - u.y * v.x;
  const double det = mean.xx * mean.yy - mean.xy * mean.xy;
  if (!(doubled > 0) || !(det > 0)) return std::numeric_limits<double>::infinity();
  const double squares =
      squared_length(mean, u) + squared_length(mean, v) + squared_length(mean, w);
  // |J|² is 2/3 of the squares, and the determinant of J the area over that of the unit triangle.
  const double area_squared = doubled * doubled * det * (4.0 / 3);
  return 2.0 / 3 * squares * (1 + 1 / area_squared);
}
inline Metric2 mean_metric(const Metric2& a, const Metric2& b, const Metric2& c) {
  return {(a.xx + b.xx + c.xx) / 3, (a.xy + b.xy + c.xy) / 3, (a.yy + b.yy + c.yy) / 3};
}
inline double triangle_energy(const MetricMesh& mesh, const TriangleComplex::Nodes& nodes) {
  const auto& [a, b, c] = nodes;
  return triangle_energy(
      mesh.complex.point(a), mesh.complex.point(b), mesh.complex.point(c),
      mean_metric(mesh.metrics[at(a)], mesh.metrics[at(b)], mesh.metrics[at(c)]));
}
/// Of a node at the place, with two of the mesh.
inline double triangle_energy(const MetricMesh& mesh, const NodePlace& place, std::int32_t b,
                              std::int32_t c) {
  return triangle_energy(place.point, mesh.complex.point(b), mesh.complex.point(c),
                         mean_metric(place.metric, mesh.metrics[at(b)], mesh.metrics[at(c)]));
}

/// The triangles round a node, anticlockwise; from the border on where it has one. Triangles
/// beyond constrained edges inside are among them.
struct Ball {
  std::vector<EdgeHandle> corners;  ///< triangle << 2 | local number of the node
  bool is_closed = true;
};
void collect_ball(const TriangleComplex& complex, std::int32_t node, Ball& ball);

/// The edge opposite the node in a triangle of its ball, as the triangle runs.
struct OppositeEdge {
  std::int32_t before = 0, after = 0;
};
inline OppositeEdge opposite_edge(const TriangleComplex& complex, EdgeHandle corner) {
  const std::int32_t t = triangle_of(corner);
  const int i = edge_of(corner);
  return {complex.node(t, next(i)), complex.node(t, previous(i))};
}
/// Whether every triangle of the ball still turns anticlockwise with its node at the point. Exact.
bool sees_ball(const TriangleComplex& complex, const Ball& ball, const Vec2& point);

/// What breaks the invariants, a line each (at most 20).
std::vector<std::string> validate(const MetricMesh& mesh);

}  // namespace tetfarm
