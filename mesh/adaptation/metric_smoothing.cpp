#include "mesh/adaptation/metric_smoothing.h"

#include <cmath>
#include <optional>

#include "base/array_index.h"
#include "mesh/adaptation/node_ring.h"

namespace tetfarm {
namespace {

// A gain below this share of the energy is not worth a step.
constexpr double least_gain = 3e-5;
constexpr double unit_height = 0.8660254037844386;

struct Step {
  NodePlace place;
  double parameter = 0;
};

/// The mean of the apexes of the unit triangles on the edges opposite the node.
Vec2 optimal_point(const MetricMesh& mesh, const NodeRing& ring, std::int32_t node) {
  const Metric2& m = mesh.metrics[at(node)];
  const Vec2& here = mesh.complex.point(node);
  // The apex lies M-orthogonal to the edge e, to its left: J M e / sqrt(det M) has e's own metric
  // length.
  const double height = unit_height / std::sqrt(determinant(m));
  const std::vector<NodeRing::Place>& places = ring.places();
  Vec2 sum;
  for (std::size_t k = 0; k + 1 < places.size(); ++k) {
    const Vec2& a = places[k].point;
    const Vec2& b = places[k + 1].point;
    const Vec2 edge{b.x - a.x, b.y - a.y};
    const Vec2 image{m.xx * edge.x + m.xy * edge.y, m.xy * edge.x + m.yy * edge.y};
    const double scale = height / std::sqrt(edge.x * image.x + edge.y * image.y);
    sum.x += (a.x + b.x) / 2 - here.x - scale * image.y;
    sum.y += (a.y + b.y) / 2 - here.y + scale * image.x;
  }
  const auto count = static_cast<double>(ring.triangles());
  return {here.x + sum.x / count, here.y + sum.y / count};
}

/// Halfway between where the node is and where it has the same metric length to both sides along
/// its curve; nothing where the ball has no two neighbours on it.
std::optional<double> optimal_parameter(const MetricMesh& mesh, const NodeRing& ring,
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
  for (const NodeRing::Place& place : ring.places()) note(place.node);
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

bool smooth_node(MetricMesh& mesh, const MetricField& field, std::int32_t node, NodeRing& ring) {
  if (mesh.curve_of_node[at(node)] == MetricMesh::corner) return false;
  ring.gather(mesh, node);
  Vec2 goal;
  std::optional<double> parameter;
  if (mesh.is_inside(node)) {
    goal = optimal_point(mesh, ring, node);
  } else {
    parameter = optimal_parameter(mesh, ring, node);
    if (!parameter.has_value()) return false;
  }
  const double allowed = ring.noted_sum(mesh) * (1 - least_gain);
  for (const double share : {1.7, 0.8, 0.4}) {
    const std::optional<Step> step = step_of(mesh, field, node, goal, parameter, share);
    if (!step.has_value()) return false;
    const RingEnergies after = ring.energies_at(step->place);
    if (!(after.sum < allowed)) continue;
    if (!after.is_certain && !ring.sees_all(mesh, step->place.point)) continue;
    move_node(mesh, node, step->place);
    mesh.parameters[at(node)] = step->parameter;
    ring.note(mesh);
    ring.activate(mesh);
    return true;
  }
  return false;
}

}  // namespace

std::int64_t smooth_nodes(MetricMesh& mesh, const MetricField& field) {
  std::int64_t moved = 0;
  NodeRing ring;
  for (std::int32_t node = 0; node < mesh.nodes(); ++node) {
    if (mesh.complex.node2triangle[at(node)] < 0 || mesh.active[at(node)] == 0) continue;
    const bool has_moved = smooth_node(mesh, field, node, ring);
    mesh.active[at(node)] = has_moved ? 1 : 0;
    moved += has_moved ? 1 : 0;
  }
  return moved;
}

}  // namespace tetfarm
