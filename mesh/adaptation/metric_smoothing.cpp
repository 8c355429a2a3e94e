#include "mesh/adaptation/metric_smoothing.h"

#include <cmath>
#include <optional>

#include "base/array_index.h"

namespace tetfarm {
namespace {

// A gain below this share of the energy is not worth a step.
constexpr double least_gain = 3e-5;
constexpr double unit_height = 0.8660254037844386;

struct Step {
  NodePlace place;
  double parameter = 0;
};

double ball_energy(const MetricMesh& mesh, const Ball& ball, const NodePlace& place) {
  double sum = 0;
  for (const EdgeHandle corner : ball.corners) {
    const OppositeEdge sides = opposite_edge(mesh.complex, corner);
    sum += triangle_energy(mesh, place, sides.before, sides.after);
  }
  return sum;
}

/// The mean of the apexes of the unit triangles on the edges opposite the node.
Vec2 optimal_point(const MetricMesh& mesh, const Ball& ball, std::int32_t node) {
  const Metric2& m = mesh.metrics[at(node)];
  const Vec2& here = mesh.complex.point(node);
  const double density = mesh.densities[at(node)];
  Vec2 sum;
  for (const EdgeHandle corner : ball.corners) {
    const OppositeEdge sides = opposite_edge(mesh.complex, corner);
    const Vec2& a = mesh.complex.point(sides.before);
    const Vec2& b = mesh.complex.point(sides.after);
    const Vec2 edge{b.x - a.x, b.y - a.y};
    // M-orthogonal to the edge, to its left, and of the edge's metric length: J M e / sqrt(det M).
    const Vec2 normal{-(m.xy * edge.x + m.yy * edge.y) / density,
                      (m.xx * edge.x + m.xy * edge.y) / density};
    const double scale = unit_height / std::sqrt(squared_length(m, edge));
    sum.x += (a.x + b.x) / 2 + scale * normal.x - here.x;
    sum.y += (a.y + b.y) / 2 + scale * normal.y - here.y;
  }
  const auto count = static_cast<double>(ball.corners.size());
  return {here.x + sum.x / count, here.y + sum.y / count};
}

/// Halfway between where the node is and where it has the same metric length to both sides along
/// its curve; nothing where the ball has no two neighbours on it.
std::optional<double> optimal_parameter(const MetricMesh& mesh, const Ball& ball,
                                        std::int32_t node) {
  const std::int32_t curve = mesh.curve_of_node[at(node)];
  const BoundaryCurve& shape = mesh.curves[at(curve)].shape;
  const double here = mesh.parameters[at(node)];
  double way_down = 0, way_up = 0, length_down = 0, length_up = 0;
  const auto note = [&](std::int32_t end) {
    if (curve_of_edge(mesh, node, end) != curve) return;
    const double way = shape.way(here, parameter_on(mesh, curve, end, here));
    (way < 0 ? way_down : way_up) = way;
    (way < 0 ? length_down : length_up) = edge_length(mesh, node, end);
  };
  for (const EdgeHandle corner : ball.corners) {
    note(opposite_edge(mesh.complex, corner).before);
    note(opposite_edge(mesh.complex, corner).after);
  }
  if (length_down <= 0 || length_up <= 0) return std::nullopt;
  const double excess = (length_up - length_down) / 2;
  return here + (excess > 0 ? excess * way_up / length_up : -excess * way_down / length_down);
}

std::optional<Step> step_of(const MetricMesh& mesh, const MetricField& field, std::int32_t node,
                            const Vec2& goal, std::optional<double> parameter, double share) {
  Step step;
  const Vec2& here = mesh.complex.point(node);
  if (mesh.is_inside(node)) {
    step.place.point = {here.x + share * (goal.x - here.x), here.y + share * (goal.y - here.y)};
  } else {
    const BoundaryCurve& shape = mesh.curves[at(mesh.curve_of_node[at(node)])].shape;
    const double from = mesh.parameters[at(node)];
    step.parameter = shape.within(from + share * (*parameter - from));
    step.place.point = shape.at(step.parameter);
  }
  if (step.place.point == here) return std::nullopt;
  step.place.home = mesh.homes[at(node)];
  step.place.metric = field.at(step.place.point, step.place.home);
  return step;
}

bool smooth_node(MetricMesh& mesh, const MetricField& field, std::int32_t node, Ball& ball) {
  if (mesh.curve_of_node[at(node)] == MetricMesh::corner) return false;
  collect_ball(mesh.complex, node, ball);
  Vec2 goal;
  std::optional<double> parameter;
  if (mesh.is_inside(node)) {
    goal = optimal_point(mesh, ball, node);
  } else {
    parameter = optimal_parameter(mesh, ball, node);
    if (!parameter.has_value()) return false;
  }
  const double before = ball_energy(mesh, ball, place_of(mesh, node));
  for (const double share : {1.7, 0.8, 0.4}) {
    const std::optional<Step> step = step_of(mesh, field, node, goal, parameter, share);
    if (!step.has_value()) return false;
    if (!(ball_energy(mesh, ball, step->place) < before * (1 - least_gain))) continue;
    if (!sees_ball(mesh.complex, ball, step->place.point)) continue;
    move_node(mesh, node, step->place);
    mesh.parameters[at(node)] = step->parameter;
    for (const EdgeHandle corner : ball.corners) {
      mesh.active[at(opposite_edge(mesh.complex, corner).before)] = 1;
      mesh.active[at(opposite_edge(mesh.complex, corner).after)] = 1;
    }
    return true;
  }
  return false;
}

}  // namespace

std::int64_t smooth_nodes(MetricMesh& mesh, const MetricField& field) {
  std::int64_t moved = 0;
  Ball ball;
  for (std::int32_t node = 0; node < mesh.nodes(); ++node) {
    if (mesh.complex.node2triangle[at(node)] < 0 || mesh.active[at(node)] == 0) continue;
    const bool has_moved = smooth_node(mesh, field, node, ball);
    mesh.active[at(node)] = has_moved ? 1 : 0;
    moved += has_moved ? 1 : 0;
  }
  return moved;
}

}  // namespace tetfarm
