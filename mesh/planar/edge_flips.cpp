#include "mesh/planar/edge_flips.h"

namespace tetfarm {

bool is_locally_delaunay(const TriangleComplex& complex, EdgeHandle edge) {
  const std::int32_t t = triangle_of(edge);
  const int i = edge_of(edge);
  if (complex.is_constrained(t, i)) return true;
  const EdgeHandle other = complex.neighbour(t, i);
  const auto& [a, b, c] = complex.nodes(t);
  const std::int32_t apex = complex.node(triangle_of(other), edge_of(other));
  return !(incircle(complex.point(a), complex.point(b), complex.point(c), complex.point(apex)) > 0);
}

std::size_t flip_to_delaunay(TriangleComplex& complex) {
  std::size_t flips = 0;
  std::vector<EdgeHandle> stack;
  for (std::int32_t t = 0; t < complex.size(); ++t) {
    for (int i = 0; i < 3; ++i) {
      // Each edge once: from the lower triangle.
      if (complex.neighbour(t, i) < edge_handle(t, 0)) continue;
      stack.push_back(edge_handle(t, i));
      while (!stack.empty()) {
        const EdgeHandle edge = stack.back();
        stack.pop_back();
        if (is_locally_delaunay(complex, edge)) continue;
        const std::int32_t u = triangle_of(edge);
        const std::int32_t v = triangle_of(complex.neighbour(u, edge_of(edge)));
        complex.flip(edge);
        ++flips;
        // flip leaves the quadrilateral's four sides on edges 0 and 2 of u, 0 and 1 of v.
        stack.insert(stack.end(),
                     {edge_handle(v, 1), edge_handle(v, 0), edge_handle(u, 2), edge_handle(u, 0)});
      }
    }
  }
  return flips;
}

}  // namespace tetfarm
