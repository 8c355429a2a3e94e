#include "mesh/decompose/lift_heights.h"

#include <algorithm>
#include <cmath>

#include "base/array_index.h"
#include "base/check.h"
#include "mesh/decompose/surface_topology.h"

namespace tetfarm {
namespace {

double cross2(const Vec2& a, const Vec2& b) { return a.x * b.y - a.y * b.x; }
double dot2(const Vec2& a, const Vec2& b) { return a.x * b.x + a.y * b.y; }
Vec2 from_to(const Vec2& a, const Vec2& b) { return {b.x - a.x, b.y - a.y}; }

/// sum of w (x_i - x_j)^2 + sum of d x_i^2 - 2 sum of b x_i, least where its gradient vanishes.
struct Quadratic {
  struct Link {
    std::int32_t a = 0;
    std::int32_t b = 0;
    double weight = 0;
  };
  std::vector<Link> links;
  std::vector<double> diagonal;
  std::vector<double> right_side;
};

/// The height that puts the apex of a rim triangle on the bisector, its slope capped.
double bisector_height(const InterdomainMesh& mesh, const RimCorner& corner, std::int32_t from,
                       std::int32_t to, std::int32_t apex, double steepest_slope) {
  const Vec2& a = mesh.planar.points[at(from)];
  const Vec2 edge = from_to(a, mesh.planar.points[at(to)]);
  const double length = std::sqrt(dot2(edge, edge));
  const Vec2 along{edge.x / length, edge.y / length};
  const Vec2 inward{-along.y, along.x};
  const Vec3 towards = bisector(corner);
  const Vec2 towards2 = {dot(towards, mesh.plane.u), dot(towards, mesh.plane.v)};
  const double slope_along = (mesh.heights[at(to)] - mesh.heights[at(from)]) / length;
  const double rise = dot(towards, mesh.plane.normal) - slope_along * dot2(towards2, along);
  const double run = dot2(towards2, inward);
  const double slope =
      std::fabs(rise) < steepest_slope * run ? rise / run : std::copysign(steepest_slope, rise);
  const Vec2 to_apex = from_to(a, mesh.planar.points[at(apex)]);
  return mesh.heights[at(from)] + slope_along * dot2(to_apex, along) +
         slope * dot2(to_apex, inward);
}

Quadratic assemble(const InterdomainMesh& mesh, const std::vector<RimCorner>& corners,
                   const std::vector<double>& bisector_weights, const LiftOptions& options) {
  const std::vector<Vec2>& points = mesh.planar.points;
  TF_CHECK(corners.size() == mesh.rim.size() && bisector_weights.size() == mesh.rim.size());
  Quadratic q{{}, std::vector<double>(points.size(), 0.0), std::vector<double>(points.size(), 0.0)};
  for (const auto& t : mesh.planar.triangles) {
    const double twice_area = cross2(from_to(points[at(t[0])], points[at(t[1])]),
                                     from_to(points[at(t[0])], points[at(t[2])]));
    for (std::size_t k = 0; k < 3; ++k) {
      const std::int32_t i = t[k];
      const std::int32_t j = t[(k + 1) % 3];
      const std::int32_t opposite = t[(k + 2) % 3];
      const double cotangent = dot2(from_to(points[at(opposite)], points[at(i)]),
                                    from_to(points[at(opposite)], points[at(j)])) /
                               twice_area;
      constexpr double least = 0.05;  // keeps the system positive where angles are obtuse
      constexpr double most = 10;
      q.links.push_back({i, j, 0.5 * std::clamp(cotangent, least, most)});
      const double reach = options.decay * mesh.spacing[at(i)];
      q.diagonal[at(i)] += twice_area / 6 / (reach * reach);
    }
  }
  for (std::size_t i = 0; i < mesh.rim.size(); ++i) {
    const std::int32_t from = mesh.rim_nodes[i][0];
    const std::int32_t to = mesh.rim_nodes[i][1];
    const std::int32_t apex = apex_of_rim_triangle(mesh, i);
    if (mesh.is_rim_node(apex)) continue;
    const double target = bisector_height(mesh, corners[i], from, to, apex, options.steepest_slope);
    q.diagonal[at(apex)] += bisector_weights[i];
    q.right_side[at(apex)] += bisector_weights[i] * target;
  }
  return q;
}

/// Conjugate gradients with a diagonal preconditioner for the nodes that are free; the others keep
/// x.
void minimise(const Quadratic& q, const std::vector<bool>& is_free, std::vector<double>& x) {
  const std::size_t n = x.size();
  std::vector<double> preconditioner = q.diagonal;
  TF_CHECK(is_free.size() == n && q.diagonal.size() == n);
  for (const auto& link : q.links) {
    preconditioner[at(link.a)] += link.weight;
    preconditioner[at(link.b)] += link.weight;
  }
  const auto apply = [&](const std::vector<double>& v, std::vector<double>& out) {
    for (std::size_t i = 0; i < n; ++i) out[i] = q.diagonal[i] * v[i];
    for (const auto& [a, b, weight] : q.links) {
      const double flow = weight * (v[at(a)] - v[at(b)]);
      out[at(a)] += flow;
      out[at(b)] -= flow;
    }
  };
  std::vector<double> product(n);
  std::vector<double> residual(n, 0.0);
  std::vector<double> direction(n, 0.0);
  apply(x, product);
  double energy = 0;
  for (std::size_t i = 0; i < n; ++i) {
    if (!is_free[i]) continue;
    residual[i] = q.right_side[i] - product[i];
    direction[i] = residual[i] / preconditioner[i];
    energy += residual[i] * direction[i];
  }
  constexpr int most_iterations = 200;
  constexpr double accuracy = 1e-10;  // of the squared residual
  const double enough = accuracy * energy;
  for (int iteration = 0; iteration < most_iterations && energy > enough; ++iteration) {
    apply(direction, product);
    double curvature = 0;
    for (std::size_t i = 0; i < n; ++i) curvature += direction[i] * product[i];
    const double step = energy / curvature;
    double next_energy = 0;
    for (std::size_t i = 0; i < n; ++i) {
      if (!is_free[i]) continue;
      x[i] += step * direction[i];
      residual[i] -= step * product[i];
      next_energy += residual[i] * residual[i] / preconditioner[i];
    }
    for (std::size_t i = 0; i < n; ++i) {
      if (is_free[i])
        direction[i] = residual[i] / preconditioner[i] + next_energy / energy * direction[i];
    }
    energy = next_energy;
  }
}

}  // namespace

void lift_heights(InterdomainMesh& mesh, const std::vector<RimCorner>& corners,
                  const std::vector<double>& bisector_weights,
                  const std::vector<std::optional<double>>& pushed, const LiftOptions& options) {
  TF_CHECK(mesh.heights.size() == mesh.planar.points.size());
  std::vector<bool> is_free(mesh.heights.size(), true);
  for (std::size_t i = 0; i < mesh.heights.size(); ++i) {
    if (i < mesh.rim_vertices.size()) is_free[i] = false;
    if (i < pushed.size() && pushed[i]) {
      is_free[i] = false;
      mesh.heights[i] = *pushed[i];
    }
  }
  minimise(assemble(mesh, corners, bisector_weights, options), is_free, mesh.heights);
}

}  // namespace tetfarm
