#include "mesh/adaptation/misfit_mending.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/array_index.h"

namespace tetfarm {
namespace {

constexpr double first_step = 0.12;  ///< of a unit of metric length
constexpr int halvings = 4;
constexpr double weight_of_length = 300;

bool fits(const MetricMesh& mesh, const TriangleComplex::Nodes& n, const FittingLimits& limits) {
  if (triangle_energy(mesh, n) > limits.worst_energy) return false;
  for (int i = 0; i < 3; ++i) {
    const double length = edge_length(mesh, n[at(i)], n[at(next(i))]);
    if (length < limits.shortest || length > limits.longest) return false;
  }
  return true;
}

class NodeSearch {
 public:
  NodeSearch(const MetricMesh& mesh, const FittingLimits& limits) : mesh_(mesh), limits_(limits) {}

  void at_node(std::int32_t node) { collect_ball(mesh_.complex, node, ball_); }

  /// What the node costs at the place; infinite where a triangle would turn over.
  double cost(const NodePlace& place) const {
    double sum = 0;
    for (const EdgeHandle corner : ball_.corners) {
      const OppositeEdge edge = opposite_edge(mesh_.complex, corner);
      const double energy = triangle_energy(mesh_, place, edge.before, edge.after) / 4;
      const double beyond = excess(edge_length(mesh_, place, edge.before));
      sum += energy * energy * energy + weight_of_length * beyond * beyond;
    }
    return sum;
  }

  bool sees_all(const Vec2& point) const { return sees_ball(mesh_.complex, ball_, point); }

  void activate(MetricMesh& mesh) const {
    for (const EdgeHandle corner : ball_.corners) {
      for (const std::int32_t v : mesh.complex.nodes(triangle_of(corner))) mesh.active[at(v)] = 1;
    }
  }

 private:
  double excess(double length) const {
    return std::max({0.0, length / limits_.longest - 1, limits_.shortest / length - 1});
  }

  const MetricMesh& mesh_;
  const FittingLimits& limits_;
  Ball ball_;
};

/// Eight directions of unit metric length.
std::array<Vec2, 8> unit_directions(const Metric2& m) {
  // With m = Lᵀ L, L = [p q; 0 r], the direction of (c, s) is L⁻¹ (c, s).
  const double p = std::sqrt(m.xx);
  const double q = m.xy / p;
  const double r = std::sqrt(std::max(determinant(m) / m.xx, 0.0));
  constexpr double diagonal = 0.7071067811865476;
  constexpr std::array<Vec2, 8> circle{{{1, 0},
                                        {diagonal, diagonal},
                                        {0, 1},
                                        {-diagonal, diagonal},
                                        {-1, 0},
                                        {-diagonal, -diagonal},
                                        {0, -1},
                                        {diagonal, -diagonal}}};
  std::array<Vec2, 8> directions{};
  for (std::size_t i = 0; i < 8; ++i) {
    const double y = circle[i].y / r;
    directions[i] = {(circle[i].x - q * y) / p, y};
  }
  return directions;
}

bool mend_node(MetricMesh& mesh, const MetricField& field, std::int32_t node, NodeSearch& search) {
  if (!mesh.is_inside(node)) return false;
  search.at_node(node);
  NodePlace best = place_of(mesh, node);
  const double cost_before = search.cost(best);
  double least = cost_before;
  const std::array<Vec2, 8> directions = unit_directions(best.metric);
  double step = first_step;
  for (int halved = 0; halved < halvings;) {
    const NodePlace from = best;
    for (const Vec2& direction : directions) {
      NodePlace place = from;
      place.point = {from.point.x + step * direction.x, from.point.y + step * direction.y};
      place.metric = field.at(place.point, place.home);
      const double cost = search.cost(place);
      if (cost < least * (1 - 1e-4) && search.sees_all(place.point)) {
        least = cost;
        best = place;
      }
    }
    if (best.point == from.point) {
      step /= 2;
      ++halved;
    }
  }
  if (least > cost_before * (1 - 1e-3)) return false;
  move_node(mesh, node, best);
  search.activate(mesh);
  return true;
}

}  // namespace

std::int64_t activate_misfits(MetricMesh& mesh, const FittingLimits& limits) {
  std::int64_t misfits = 0;
  for (std::int32_t t = 0; t < mesh.complex.size(); ++t) {
    if (!mesh.is_used(t) || fits(mesh, mesh.complex.nodes(t), limits)) continue;
    ++misfits;
    for (const std::int32_t v : mesh.complex.nodes(t)) mesh.active[at(v)] = 1;
  }
  return misfits;
}

std::int64_t mend_misfits(MetricMesh& mesh, const MetricField& field, const FittingLimits& limits) {
  std::fill(mesh.active.begin(), mesh.active.end(), std::uint8_t{0});
  activate_misfits(mesh, limits);
  const std::vector<std::uint8_t> to_mend = mesh.active;
  NodeSearch search(mesh, limits);
  std::int64_t moved = 0;
  for (std::int32_t node = 0; node < mesh.nodes(); ++node) {
    if (to_mend[at(node)] == 0 || mesh.complex.node2triangle[at(node)] < 0) continue;
    moved += mend_node(mesh, field, node, search) ? 1 : 0;
  }
  return moved;
}

}  // namespace tetfarm
