/// The mesh while it is adapted: triangles with a metric at each node, and what holds the boundary.
///
/// Lengths of edges and shapes of triangles are measured by the metrics of their nodes alone; the
/// metrics come from the background (MetricField) when a node is made or moved.
#pragma once

#include <algorithm>
#include <cmath>
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
/// `curve_of_edge`; 3. a node with curve >= 0 lies at its parameter; 4. an energy that is known is
/// that of its triangle.
struct MetricMesh {
  static constexpr float unknown_energy = -1;
  static constexpr std::int32_t inside = -1;  ///< for curve_of_node: on no curve
  static constexpr std::int32_t corner = -2;  ///< never moves, never goes

  TriangleComplex complex;
  std::vector<std::int32_t> regions;  ///< of each triangle
  std::vector<std::int32_t> unused;   ///< triangles that are none; their first node is -1

  std::vector<Metric2> metrics;
  std::vector<std::int32_t> homes;          ///< triangles of the background
  std::vector<std::int32_t> curve_of_node;  ///< number of a curve, `inside` or `corner`
  std::vector<double> parameters;           ///< on that curve
  std::vector<std::uint8_t> active;         ///< near something that changed, or is to be mended
  std::vector<std::uint8_t> touched;        ///< of each node: bits of TouchedBits

  /// Of each triangle: triangle_energy(), rounded; `unknown_energy` where it has to be taken anew.
  std::vector<float> energies;
  /// Of each triangle: bits of SwapCriterion by which its edges are to be looked at.
  std::vector<std::uint8_t> unchecked;

  std::vector<MeshCurve> curves;
  std::unordered_map<std::uint64_t, std::int32_t> curve_of_edge;

  std::int32_t nodes() const { return static_cast<std::int32_t>(complex.points.size()); }
  bool is_used(std::int32_t triangle) const { return complex.node(triangle, 0) >= 0; }
  bool is_inside(std::int32_t node) const {
    return curve_of_node[static_cast<std::size_t>(node)] == inside;
  }
};

/// Of `touched`: something changed in the ball of the node, since the round began or in that
/// before.
struct TouchedBits {
  static constexpr std::uint8_t now = 1, before = 2;
};
/// What is touched from now on belongs to the next round.
void begin_round(MetricMesh& mesh);
/// The triangle has another shape or other nodes: its energy is unknown and its edges unchecked.
void note_change(MetricMesh& mesh, std::int32_t triangle);

/// Which edges an operation looks at.
enum class EdgesToVisit {
  all,
  active,  ///< those with an active node
  touched  ///< those with a node that was touched in this round or the one before
};
inline bool is_to_visit(const MetricMesh& mesh, EdgesToVisit which, std::int32_t a,
                        std::int32_t b) {
  if (which == EdgesToVisit::all) return true;
  const std::vector<std::uint8_t>& marks =
      which == EdgesToVisit::active ? mesh.active : mesh.touched;
  return (marks[at(a)] | marks[at(b)]) != 0;
}

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
/// Its triangles are not told: see note_change().
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

/// Whether an edge of the squared lengths a and b by its two ends is longer than the limit: mostly
/// without the roots and the logarithm, as its length lies between the two.
inline bool is_longer(double a, double b, double limit) {
  const double square = limit * limit;
  if (std::max(a, b) <= square) return false;
  if (std::min(a, b) > square * (1 + 1e-12)) return true;
  return length_between(std::sqrt(a), std::sqrt(b)) > limit;
}
inline bool is_shorter(double a, double b, double limit) {
  const double square = limit * limit;
  if (std::min(a, b) >= square) return false;
  if (std::max(a, b) < square * (1 - 1e-12)) return true;
  return length_between(std::sqrt(a), std::sqrt(b)) < limit;
}
/// The squared lengths of an edge by its two ends.
struct SquaredLengths {
  double first = 0, second = 0;
};
inline SquaredLengths squared_lengths(const MetricMesh& mesh, std::int32_t a, std::int32_t b) {
  const Vec2& p = mesh.complex.point(a);
  const Vec2& q = mesh.complex.point(b);
  const Vec2 edge{q.x - p.x, q.y - p.y};
  return {squared_length(mesh.metrics[at(a)], edge), squared_length(mesh.metrics[at(b)], edge)};
}
inline bool is_longer(const MetricMesh& mesh, std::int32_t a, std::int32_t b, double limit) {
  const SquaredLengths squares = squared_lengths(mesh, a, b);
  return is_longer(squares.first, squares.second, limit);
}
inline bool is_shorter(const MetricMesh& mesh, std::int32_t a, std::int32_t b, double limit) {
  const SquaredLengths squares = squared_lengths(mesh, a, b);
  return is_shorter(squares.first, squares.second, limit);
}

/// How far a triangle is from an equilateral one of unit edges, by the mean of the metrics of its
/// nodes: the symmetric Dirichlet energy |J|² + |J⁻¹|² of the map from that triangle, 4 when equal;
/// infinite when it does not turn anticlockwise.
/// `sum`: of the three metrics.
inline double energy_of_sides(const Vec2& u, const Vec2& v, double doubled, const Metric2& sum) {
  const double det = sum.xx * sum.yy - sum.xy * sum.xy;
  if (!(doubled > 0) || !(det > 0)) return std::numeric_limits<double>::infinity();
  const Vec2 w{v.x - u.x, v.y - u.y};
  const double squares = sum.xx * (u.x * u.x + v.x * v.x + w.x * w.x) +
                         2 * sum.xy * (u.x * u.y + v.x * v.y + w.x * w.y) +
                         sum.yy * (u.y * u.y + v.y * v.y + w.y * w.y);
  // |J|² is 2/3 of the squares by the mean, and the determinant of J the area over that of the unit
  // triangle.
  return 2.0 / 9 * squares * (1 + 6.75 / (doubled * doubled * det));
}
inline Metric2 sum_of(const Metric2& a, const Metric2& b) {
  return {a.xx + b.xx, a.xy + b.xy, a.yy + b.yy};
}
inline double triangle_energy(const MetricMesh& mesh, const TriangleComplex::Nodes& nodes) {
  const auto& [a, b, c] = nodes;
  const Vec2& p = mesh.complex.point(a);
  const Vec2& q = mesh.complex.point(b);
  const Vec2& r = mesh.complex.point(c);
  const Vec2 u{q.x - p.x, q.y - p.y};
  const Vec2 v{r.x - p.x, r.y - p.y};
  return energy_of_sides(
      u, v, u.x * v.y - u.y * v.x,
      sum_of(sum_of(mesh.metrics[at(a)], mesh.metrics[at(b)]), mesh.metrics[at(c)]));
}
/// As it is noted.
inline float noted_energy(double energy) { return static_cast<float>(std::min(energy, 1e30)); }
/// The same, taken once for as long as the triangle does not change.
inline float known_energy(MetricMesh& mesh, std::int32_t triangle) {
  float& energy = mesh.energies[at(triangle)];
  if (energy < 0) energy = noted_energy(triangle_energy(mesh, mesh.complex.nodes(triangle)));
  return energy;
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
