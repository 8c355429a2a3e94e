#include "mesh/adaptation/edge_refinement.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/array_index.h"
#include "mesh/adaptation/edge_collapse.h"

namespace tetfarm {
namespace {

struct NewNode {
  NodePlace place;
  std::int32_t curve = MetricMesh::inside;
  double parameter = 0;
};

/// At a share of the way from a to b, on the curve of the edge where it has one.
NewNode node_on_edge(const MetricMesh& mesh, const MetricField& field, std::int32_t a,
                     std::int32_t b, bool is_constrained, double share) {
  NewNode node;
  if (is_constrained) {
    node.curve = curve_of_edge(mesh, a, b);
    const BoundaryCurve& shape = mesh.curves[at(node.curve)].shape;
    const double middle = shape.length() / 2;
    const bool a_is_on_it = mesh.curve_of_node[at(a)] == node.curve;
    const double of_b =
        parameter_on(mesh, node.curve, b, a_is_on_it ? mesh.parameters[at(a)] : middle + middle);
    const double of_a = parameter_on(mesh, node.curve, a,
                                     a_is_on_it               ? middle
                                     : of_b == shape.length() ? 0
                                                              : of_b);
    node.parameter = shape.within(of_a + share * shape.way(of_a, of_b));
    node.place.point = shape.at(node.parameter);
  } else {
    const Vec2& from = mesh.complex.point(a);
    const Vec2& to = mesh.complex.point(b);
    node.place.point = {from.x + share * (to.x - from.x), from.y + share * (to.y - from.y)};
  }
  node.place.home = mesh.homes[at(a)];
  node.place.metric = field.at(node.place.point, node.place.home);
  return node;
}

/// A node of a curve takes in those inside that it came too near to.
void join_near_nodes(MetricMesh& mesh, std::int32_t node, const std::vector<std::int32_t>& around,
                     double shortest) {
  Ball ball;
  for (const std::int32_t near : around) {
    if (!mesh.is_inside(near) || edge_length(mesh, node, near) >= shortest) continue;
    collapse_node(mesh, near, node, {shortest, 4, 1e6}, ball);
  }
}

/// The share of the way from a to b at which a part of its metric length has been passed.
double share_of_part(const MetricMesh& mesh, std::int32_t a, std::int32_t b, double part) {
  const Vec2& from = mesh.complex.point(a);
  const Vec2& to = mesh.complex.point(b);
  const Vec2 edge{to.x - from.x, to.y - from.y};
  return share_at_length(std::sqrt(squared_length(mesh.metrics[at(a)], edge)),
                         std::sqrt(squared_length(mesh.metrics[at(b)], edge)), part);
}

/// Nodes on one long edge, from its beginning on; where one has no room the next is tried. Returns
/// how many came.
std::int64_t refine_edge(MetricMesh& mesh, const MetricField& field, EllipseCavity& cavity,
                         EdgeHandle edge, const RefinementLimits& limits) {
  std::int64_t nodes = 0;
  std::int32_t start = mesh.complex.node(triangle_of(edge), next(edge_of(edge)));
  const std::int32_t end = mesh.complex.node(triangle_of(edge), previous(edge_of(edge)));
  int passed = 1;
  while (edge != no_edge &&
         mesh.complex.size() - std::ssize(mesh.unused) <= limits.most_triangles) {
    const double length = edge_length(mesh, start, end);
    if (length <= limits.longest) break;
    const int parts = std::max(2, static_cast<int>(std::min(std::lround(length), 1000L)));
    if (passed >= parts) break;
    const double share = share_of_part(mesh, start, end, static_cast<double>(passed) / parts);
    if (!divide_edge(mesh, field, cavity, edge, share, limits.shortest)) {
      ++passed;
      continue;
    }
    ++nodes;
    passed = 1;
    start = mesh.nodes() - 1;
    edge = mesh.complex.find_edge(start, end);
  }
  return nodes;
}

}  // namespace

bool divide_edge(MetricMesh& mesh, const MetricField& field, EllipseCavity& cavity, EdgeHandle edge,
                 double share, double shortest) {
  const std::int32_t t = triangle_of(edge);
  const int i = edge_of(edge);
  const std::int32_t a = mesh.complex.node(t, next(i));
  const std::int32_t b = mesh.complex.node(t, previous(i));
  const NewNode node = node_on_edge(mesh, field, a, b, mesh.complex.is_constrained(t, i), share);
  const bool is_on_curve = node.curve != MetricMesh::inside;
  if (is_on_curve && (edge_length(mesh, node.place, a) < shortest ||
                      edge_length(mesh, node.place, b) < shortest)) {
    return false;
  }
  if (!cavity.find(mesh, node.place, edge, is_on_curve ? 0 : shortest)) return false;
  const std::int32_t number = add_node(mesh, node.place);
  mesh.curve_of_node[at(number)] = node.curve;
  mesh.parameters[at(number)] = node.parameter;
  cavity.fill(mesh, number);
  if (is_on_curve) join_near_nodes(mesh, number, cavity.rim_nodes(), shortest);
  return true;
}

std::int64_t refine_edges(MetricMesh& mesh, const MetricField& field, EllipseCavity& cavity,
                          const RefinementLimits& limits, EdgesToVisit which, bool only_on_curves) {
  std::int64_t nodes = 0;
  // Triangles that come meanwhile have their turn the next time.
  const std::int32_t triangles = mesh.complex.size();
  const std::int32_t nodes_before = mesh.nodes();
  for (std::int32_t t = 0; t < triangles; ++t) {
    if (only_on_curves && mesh.complex.constrained[at(t)] == 0) continue;
    for (int i = 0; i < 3 && mesh.is_used(t); ++i) {
      const EdgeHandle other = mesh.complex.neighbour(t, i);
      if (other != no_edge && triangle_of(other) < t) continue;
      const std::int32_t a = mesh.complex.node(t, next(i));
      const std::int32_t b = mesh.complex.node(t, previous(i));
      if (only_on_curves && !mesh.complex.is_constrained(t, i)) continue;
      if (!is_to_visit(mesh, which, a, b) || !is_longer(mesh, a, b, limits.longest)) continue;
      if (limits.at_middles) {
        if (std::max(a, b) >= nodes_before) continue;  // half of an edge
        nodes += divide_edge(mesh, field, cavity, edge_handle(t, i), 0.5, limits.shortest) ? 1 : 0;
        continue;
      }
      nodes += refine_edge(mesh, field, cavity, edge_handle(t, i), limits);
    }
  }
  return nodes;
}

}  // namespace tetfarm
