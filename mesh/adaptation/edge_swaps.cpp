#include "mesh/adaptation/edge_swaps.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/array_index.h"

namespace tetfarm {
namespace {

// A swap for the last digits would only make results depend on rounding.
constexpr double enough_better = 1 - 1e-6;

/// The four nodes round an edge: p and q beyond it, a and b its ends.
struct Quadrilateral {
  std::int32_t p = 0, a = 0, q = 0, b = 0;
};

// Where both triangles beside an edge are below this none of the two criteria swaps it: of the
// unit square, drawn to the best size, both pairs of halves have 4.62. (Of metrics that differ a
// little at the four nodes that holds but for little.)
constexpr float surely_best = 4.6F;

// By ellipses swaps may go round in a circle where metrics vary: so many come of one edge. By
// energy they end.
constexpr std::int64_t most_swaps_at_once = 100;

/// The two triangles that would come, by their energies.
struct SwappedEnergies {
  double of_first = 0, of_second = 0;  ///< of (p, a, q) and (p, q, b)
};

bool is_better_by_energy(const MetricMesh& mesh, const Quadrilateral& at, double before,
                         SwappedEnergies& after) {
  const double allowed = before * enough_better;
  after.of_first = triangle_energy(mesh, {at.p, at.a, at.q});
  if (!(after.of_first < allowed)) return false;
  after.of_second = triangle_energy(mesh, {at.p, at.q, at.b});
  return after.of_second < allowed;
}

/// Whether the angles at p and q, by the mean metric, are together more than two right angles.
bool is_better_by_ellipse(const MetricMesh& mesh, const Quadrilateral& nodes) {
  Metric2 sum{0, 0, 0};
  for (const std::int32_t v : {nodes.p, nodes.a, nodes.q, nodes.b}) {
    const Metric2& m = mesh.metrics[at(v)];
    sum = {sum.xx + m.xx, sum.xy + m.xy, sum.yy + m.yy};
  }
  const Vec2& a = mesh.complex.point(nodes.a);
  const Vec2& b = mesh.complex.point(nodes.b);
  const auto angle_at = [&](std::int32_t apex, const Vec2& from, const Vec2& to) {
    const Vec2& p = mesh.complex.point(apex);
    const Vec2 u{from.x - p.x, from.y - p.y};
    const Vec2 v{to.x - p.x, to.y - p.y};
    return Vec2{product(sum, u, v), u.x * v.y - u.y * v.x};  // cosine and sine, but for scale
  };
  const Vec2 of_p = angle_at(nodes.p, a, b);
  const Vec2 of_q = angle_at(nodes.q, b, a);
  const double first = of_p.x * of_q.y;
  const double second = of_q.x * of_p.y;
  return first + second < -1e-9 * (std::abs(first) + std::abs(second));
}

/// Whether a swap makes it better and is possible. `after`: by energy, where it is.
bool is_better_swapped(MetricMesh& mesh, EdgeHandle edge, SwapCriterion criterion,
                       SwappedEnergies& after) {
  const TriangleComplex& complex = mesh.complex;
  const std::int32_t t = triangle_of(edge);
  const int i = edge_of(edge);
  const EdgeHandle other = complex.neighbour(t, i);
  if (other == no_edge || complex.is_constrained(t, i)) return false;
  const float before = std::max(known_energy(mesh, t), known_energy(mesh, triangle_of(other)));
  if (before < surely_best) return false;
  const Quadrilateral nodes{complex.node(t, i), complex.node(t, next(i)),
                            complex.node(triangle_of(other), edge_of(other)),
                            complex.node(t, previous(i))};
  const bool is_better = criterion == SwapCriterion::energy
                             ? is_better_by_energy(mesh, nodes, before, after)
                             : is_better_by_ellipse(mesh, nodes);
  if (!is_better) return false;
  const Vec2& p = complex.point(nodes.p);
  const Vec2& q = complex.point(nodes.q);
  return orient2d(p, complex.point(nodes.a), q) > 0 && orient2d(p, q, complex.point(nodes.b)) > 0;
}

/// The edge of both triangles t and u: its outer edges are afterwards 0 and 2 of t, 0 and 1 of u.
void swap_edge(MetricMesh& mesh, EdgeHandle edge, std::int32_t u) {
  const std::int32_t t = triangle_of(edge);
  mesh.complex.flip(edge);
  for (const std::int32_t triangle : {t, u}) {
    note_change(mesh, triangle);
    for (const std::int32_t v : mesh.complex.nodes(triangle)) {
      mesh.active[at(v)] = 1;
      mesh.touched[at(v)] |= TouchedBits::now;
    }
  }
}

}  // namespace

std::int64_t swap_edges(MetricMesh& mesh, SwapCriterion criterion, bool only_unchecked) {
  std::int64_t swaps = 0;
  const auto bit = static_cast<std::uint8_t>(criterion);
  const auto is_to_check = [&](std::int32_t t) {
    return !only_unchecked || (mesh.unchecked[at(t)] & bit) != 0;
  };
  std::vector<EdgeHandle> waiting;
  for (std::int32_t first = 0; first < mesh.complex.size(); ++first) {
    if (!mesh.is_used(first) || known_energy(mesh, first) < surely_best) continue;
    for (int i = 0; i < 3; ++i) {
      const EdgeHandle beyond = mesh.complex.neighbour(first, i);
      if (beyond == no_edge) continue;
      const std::int32_t other = triangle_of(beyond);
      if (!is_to_check(first) && !is_to_check(other)) continue;
      // An edge between two of them is looked at from the first.
      if (other < first && known_energy(mesh, other) >= surely_best) continue;
      waiting.assign(1, edge_handle(first, i));
      const std::int64_t enough = swaps + most_swaps_at_once;
      while (!waiting.empty() && swaps < enough) {
        const EdgeHandle edge = waiting.back();
        waiting.pop_back();
        SwappedEnergies after;
        if (!is_better_swapped(mesh, edge, criterion, after)) continue;
        const std::int32_t t = triangle_of(edge);
        const std::int32_t u = triangle_of(mesh.complex.neighbour(t, edge_of(edge)));
        swap_edge(mesh, edge, u);
        ++swaps;
        if (criterion == SwapCriterion::energy) {
          mesh.energies[at(t)] = noted_energy(after.of_first);
          mesh.energies[at(u)] = noted_energy(after.of_second);
        }
        for (const EdgeHandle outer :
             {edge_handle(t, 2), edge_handle(t, 0), edge_handle(u, 0), edge_handle(u, 1)}) {
          waiting.push_back(outer);
        }
      }
    }
  }
  for (std::uint8_t& bits : mesh.unchecked) bits = static_cast<std::uint8_t>(bits & ~bit);
  return swaps;
}

}  // namespace tetfarm
