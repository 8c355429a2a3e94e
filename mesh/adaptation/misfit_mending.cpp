#include "mesh/adaptation/misfit_mending.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/array_index.h"
#include "mesh/adaptation/node_ring.h"

namespace tetfarm {
namespace {

constexpr double first_step = 0.12;  ///< of a unit of metric length
constexpr int halvings = 4;
constexpr double weight_of_length = 300;

bool fits(MetricMesh& mesh, std::int32_t triangle, const FittingLimits& limits) {
  if (known_energy(mesh, triangle) > limits.worst_energy) return false;
  const TriangleComplex::Nodes& n = mesh.complex.nodes(triangle);
  for (int i = 0; i < 3; ++i) {
    const SquaredLengths squares = squared_lengths(mesh, n[at(i)], n[at(next(i))]);
    if (is_shorter(squares.first, squares.second, limits.shortest) ||
        is_longer(squares.first, squares.second, limits.longest)) {
      return false;
    }
  }
  return true;
}

class NodeSearch {
 public:
  explicit NodeSearch(const FittingLimits& limits) : limits_(limits) {}

  void at_node(const MetricMesh& mesh, std::int32_t node) { ring_.gather(mesh, node); }

  /// What the node costs at the place; infinite where a triangle would turn over, some number above
  /// `enough` where it is more.
  double cost(const NodePlace& place, double enough) {
    double sum = 0;
    is_certain_ = true;
    for (std::int32_t k = 0; k < ring_.triangles() && sum <= enough; ++k) {
      const double energy = ring_.energy(k, place, is_certain_) / 4;
      const double beyond = excess(ring_.places()[at(k)], place);
      sum += energy * energy * energy + weight_of_length * beyond * beyond;
    }
    return sum;
  }

  /// Whether every triangle turns anticlockwise at the place of the last cost().
  bool sees_all(const MetricMesh& mesh, const Vec2& point) const {
    return is_certain_ || ring_.sees_all(mesh, point);
  }

  /// The node is moved to the place.
  void move(MetricMesh& mesh, std::int32_t node, const NodePlace& place) {
    move_node(mesh, node, place);
    ring_.energies_at(place);
    ring_.note(mesh);
    mesh.active[at(node)] = 1;
    ring_.activate(mesh);
  }

 private:
  double excess(const NodeRing::Place& end, const NodePlace& place) const {
    const Vec2 edge{end.point.x - place.point.x, end.point.y - place.point.y};
    const double a = squared_length(place.metric, edge);
    const double b = squared_length(end.metric, edge);
    if (std::min(a, b) >= limits_.shortest * limits_.shortest &&
        std::max(a, b) <= limits_.longest * limits_.longest) {
      return 0;
    }
    const double length = length_between(std::sqrt(a), std::sqrt(b));
    return std::max({0.0, length / limits_.longest - 1, limits_.shortest / length - 1});
  }

  const FittingLimits& limits_;
  NodeRing ring_;
  bool is_certain_ = true;
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
  search.at_node(mesh, node);
  NodePlace best = place_of(mesh, node);
  const double cost_before = search.cost(best, std::numeric_limits<double>::infinity());
  double least = cost_before;
  const std::array<Vec2, 8> directions = unit_directions(best.metric);
  double step = first_step;
  for (int halved = 0; halved < halvings;) {
    const NodePlace from = best;
    for (const Vec2& direction : directions) {
      NodePlace place = from;
      place.point = {from.point.x + step * direction.x, from.point.y + step * direction.y};
      place.metric = field.at(place.point, place.home);
      const double enough = least * (1 - 1e-4);
      const double cost = search.cost(place, enough);
      if (cost < enough && search.sees_all(mesh, place.point)) {
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
  search.move(mesh, node, best);
  return true;
}

}  // namespace

std::int64_t activate_misfits(MetricMesh& mesh, const FittingLimits& limits) {
  std::int64_t misfits = 0;
  for (std::int32_t t = 0; t < mesh.complex.size(); ++t) {
    if (!mesh.is_used(t) || fits(mesh, t, limits)) continue;
    ++misfits;
    for (const std::int32_t v : mesh.complex.nodes(t)) mesh.active[at(v)] = 1;
  }
  return misfits;
}

std::int64_t mend_misfits(MetricMesh& mesh, const MetricField& field, const FittingLimits& limits) {
  std::fill(mesh.active.begin(), mesh.active.end(), std::uint8_t{0});
  activate_misfits(mesh, limits);
  const std::vector<std::uint8_t> to_mend = mesh.active;
  NodeSearch search(limits);
  std::int64_t moved = 0;
  for (std::int32_t node = 0; node < mesh.nodes(); ++node) {
    if (to_mend[at(node)] == 0 || mesh.complex.node2triangle[at(node)] < 0) continue;
    moved += mend_node(mesh, field, node, search) ? 1 : 0;
  }
  return moved;
}

}  // namespace tetfarm
