#include "mesh/planar/edge_recovery.h"

#include <array>
#include <cstddef>
#include <deque>
#include <utility>

#include "base/check.h"

namespace tetfarm {
namespace {

using NodePair = std::pair<std::int32_t, std::int32_t>;

struct Crossed {
  std::deque<NodePair> edges;
  std::optional<PlanarFailure> failure;
};

/// Where the segments meet, for people: rounded.
Vec2 meeting_point(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  const double side_a = orient2d(c, d, a);
  const double side_b = orient2d(c, d, b);
  const double t = side_a / (side_a - side_b);
  return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
}

/// Whether v, on the line through a and b, lies on b's side of a.
bool is_ahead(const Vec2& a, const Vec2& b, const Vec2& v) {
  return (b.x > a.x ? v.x > a.x : b.x < a.x ? v.x < a.x : b.y > a.y ? v.y > a.y : v.y < a.y);
}

Crossed failed(const char* reason, const Vec2& where) {
  return {{}, PlanarFailure{reason, {where}}};
}

/// The triangle round a whose far edge the segment to b crosses, or the failure when a node lies on
/// the segment there. @pre there is no edge a-b.
std::pair<EdgeHandle, std::optional<PlanarFailure>> first_crossed(const TriangleComplex& complex,
                                                                  std::int32_t a, std::int32_t b) {
  const Vec2& pa = complex.point(a);
  const Vec2& pb = complex.point(b);
  const std::int32_t first = complex.node2triangle[static_cast<std::size_t>(a)];
  std::int32_t t = first;
  do {
    const int local = complex.local_node(t, a);
    const Vec2& right = complex.point(complex.node(t, next(local)));
    const Vec2& left = complex.point(complex.node(t, previous(local)));
    const double side_right = orient2d(pa, pb, right);
    if (side_right == 0 && is_ahead(pa, pb, right))
      return {no_edge, PlanarFailure{"a point lies on an edge", {right}}};
    if (side_right < 0 && orient2d(pa, pb, left) > 0) return {edge_handle(t, local), std::nullopt};
    t = triangle_of(complex.neighbour(t, next(local)));
  } while (t != first);
  check_failed("the segment leaves its node", __FILE__, __LINE__);
}

/// The edges that segment a-b crosses, from a on.
Crossed crossed_edges(const TriangleComplex& complex, std::int32_t a, std::int32_t b) {
  Crossed crossed;
  auto [edge, failure] = first_crossed(complex, a, b);
  if (failure) return {{}, std::move(failure)};
  const Vec2& pa = complex.point(a);
  const Vec2& pb = complex.point(b);
  for (;;) {
    const std::int32_t t = triangle_of(edge);
    const int i = edge_of(edge);
    const std::int32_t right = complex.node(t, next(i));
    const std::int32_t left = complex.node(t, previous(i));
    if (complex.is_constrained(t, i))
      return failed("two edges cross",
                    meeting_point(pa, pb, complex.point(right), complex.point(left)));
    crossed.edges.emplace_back(right, left);
    const EdgeHandle onward = complex.neighbour(t, i);
    const std::int32_t u = triangle_of(onward);
    const int j = edge_of(onward);
    const std::int32_t apex = complex.node(u, j);
    if (apex == b) return crossed;
    const double side = orient2d(pa, pb, complex.point(apex));
    if (side == 0) return failed("a point lies on an edge", complex.point(apex));
    // The apex takes the place of the node on its side: go on across the edge opposite that node.
    edge = edge_handle(u, complex.local_node(u, side > 0 ? left : right));
  }
}

bool crosses(const Vec2& a, const Vec2& b, const Vec2& p, const Vec2& q) {
  const double side_p = orient2d(a, b, p);
  const double side_q = orient2d(a, b, q);
  return (side_p < 0 && side_q > 0) || (side_p > 0 && side_q < 0);
}

}  // namespace

std::optional<PlanarFailure> recover_edge(TriangleComplex& complex, std::int32_t a,
                                          std::int32_t b) {
  EdgeHandle edge = complex.find_edge(a, b);
  if (edge == no_edge) {
    Crossed crossed = crossed_edges(complex, a, b);
    if (crossed.failure) return crossed.failure;
    std::deque<NodePair>& queue = crossed.edges;
    // Sloan's swaps end in practice; the budget turns a circle, should there be one, into an abort.
    const std::size_t n = queue.size() + 8;
    std::size_t budget = 64 * n * n;
    while (!queue.empty()) {
      TF_CHECK(budget-- > 0);
      const auto [from, to] = queue.front();
      queue.pop_front();
      const EdgeHandle handle = complex.find_edge(from, to);
      TF_CHECK(handle != no_edge);
      const std::int32_t t = triangle_of(handle);
      const EdgeHandle other = complex.neighbour(t, edge_of(handle));
      const std::int32_t p = complex.node(t, edge_of(handle));
      const std::int32_t q = complex.node(triangle_of(other), edge_of(other));
      const Vec2& pp = complex.point(p);
      const Vec2& pq = complex.point(q);
      const bool is_convex =
          orient2d(pp, complex.point(from), pq) > 0 && orient2d(pq, complex.point(to), pp) > 0;
      if (!is_convex) {
        queue.emplace_back(from, to);
        continue;
      }
      complex.flip(handle);
      if (crosses(complex.point(a), complex.point(b), pp, pq)) queue.emplace_back(p, q);
    }
    edge = complex.find_edge(a, b);
    TF_CHECK(edge != no_edge);
  }
  complex.constrain(edge, true);
  return std::nullopt;
}

}  // namespace tetfarm
