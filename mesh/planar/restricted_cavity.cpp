#include "mesh/planar/restricted_cavity.h"

#include "base/check.h"

namespace tetfarm {

std::optional<std::int32_t> locate(const TriangleComplex& complex, std::int32_t start,
                                   const Vec2& p) {
  std::int32_t t = start;
  int entry = -1;
  // A walk in a Delaunay triangulation ends; a constrained one gives no such promise.
  for (std::size_t step = 0; step <= complex.triangles.size(); ++step) {
    int exit = -1;
    for (int i = 0; i < 3 && exit < 0; ++i) {
      if (i == entry) continue;
      if (orient2d(complex.point(complex.node(t, next(i))),
                   complex.point(complex.node(t, previous(i))), p) < 0)
        exit = i;
    }
    if (exit < 0) return t;
    if (complex.is_constrained(t, exit)) return std::nullopt;
    const EdgeHandle onward = complex.neighbour(t, exit);
    if (onward == no_edge) return std::nullopt;
    t = triangle_of(onward);
    entry = edge_of(onward);
  }
  return std::nullopt;
}

bool find_cavity(const TriangleComplex& complex, std::int32_t holder, const Vec2& p,
                 Cavity& cavity) {
  cavity.triangles.assign(1, holder);
  cavity.rim.clear();
  cavity.seen.resize(complex.triangles.size(), 0);
  ++cavity.round;
  const auto mark = [&](std::int32_t t) {
    cavity.seen[static_cast<std::size_t>(t)] = cavity.round;
  };
  mark(holder);
  // Depth first, edges in turn: so the rim comes out anticlockwise and filling needs no matching.
  cavity.stack = {edge_handle(holder, 2), edge_handle(holder, 1), edge_handle(holder, 0)};
  while (!cavity.stack.empty()) {
    const EdgeHandle edge = cavity.stack.back();
    cavity.stack.pop_back();
    const std::int32_t t = triangle_of(edge);
    const int i = edge_of(edge);
    const EdgeHandle outside = complex.neighbour(t, i);
    const bool is_constrained = complex.is_constrained(t, i);
    if (outside != no_edge && !is_constrained) {
      const std::int32_t u = triangle_of(outside);
      const auto& [a, b, c] = complex.nodes(u);
      if (cavity.seen[static_cast<std::size_t>(u)] == cavity.round) return false;
      if (incircle(complex.point(a), complex.point(b), complex.point(c), p) > 0) {
        mark(u);
        cavity.triangles.push_back(u);
        cavity.stack.push_back(edge_handle(u, previous(edge_of(outside))));
        cavity.stack.push_back(edge_handle(u, next(edge_of(outside))));
        continue;
      }
    }
    const std::int32_t from = complex.node(t, next(i));
    const std::int32_t to = complex.node(t, previous(i));
    if (!(orient2d(complex.point(from), complex.point(to), p) > 0)) return false;
    cavity.rim.push_back({from, to, outside, is_constrained});
  }
  return true;
}

std::int32_t fill_cavity(TriangleComplex& complex, const Vec2& p, Cavity& cavity) {
  // A polygon of triangles without nodes inside.
  TF_CHECK(cavity.rim.size() == cavity.triangles.size() + 2);
  const std::int32_t v = complex.add_point(p);
  while (cavity.triangles.size() < cavity.rim.size())
    cavity.triangles.push_back(complex.add_triangle());
  for (std::size_t k = 0; k < cavity.rim.size(); ++k) {
    const Cavity::RimEdge& edge = cavity.rim[k];
    const std::int32_t t = cavity.triangles[k];
    complex.set_triangle(t, {v, edge.from, edge.to});
    complex.glue(edge_handle(t, 0), edge.outside);
    if (edge.is_constrained) complex.constrain(edge_handle(t, 0), true);
  }
  for (std::size_t k = 0; k < cavity.rim.size(); ++k) {
    const std::size_t after = k + 1 < cavity.rim.size() ? k + 1 : 0;
    complex.glue(edge_handle(cavity.triangles[k], 1), edge_handle(cavity.triangles[after], 2));
  }
  return v;
}

}  // namespace tetfarm
