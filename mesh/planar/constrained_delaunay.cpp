#include "mesh/planar/constrained_delaunay.h"

#include <algorithm>
#include <cmath>

#include "base/array_index.h"
#include "base/check.h"
#include "mesh/geometry/hilbert_order.h"
#include "mesh/planar/edge_flips.h"
#include "mesh/planar/edge_recovery.h"
#include "mesh/planar/restricted_cavity.h"

namespace tetfarm {
namespace {

using Edge = std::array<std::int32_t, 2>;

/// The complaints so far; each kind keeps at most as many places as a reader can use.
struct Complaints {
  std::optional<PlanarFailure> failure;

  void add(const std::string& reason, const Vec2& where) {
    constexpr std::size_t most_places = 100;
    if (!failure) failure = PlanarFailure{reason, {}};
    if (failure->reason == reason && failure->where.size() < most_places)
      failure->where.push_back(where);
  }
};

Complaints check_edges(const PlanarRegion& region, const std::vector<Edge>& sorted) {
  Complaints complaints;
  const auto n = static_cast<std::int32_t>(region.points.size());
  for (const Vec2& p : region.points)
    if (!std::isfinite(p.x) || !std::isfinite(p.y)) complaints.add("a coordinate is not finite", p);
  if (region.edges.empty()) complaints.add("the region has no edges", {});
  for (const auto& [a, b] : sorted)
    if (a < 0 || b < 0 || a >= n || b >= n)
      complaints.add("an edge names a point that does not exist", {});
  if (complaints.failure) return complaints;

  std::vector<std::int32_t> surplus(region.points.size(), 0);
  for (const auto& [a, b] : sorted) {
    if (a == b) complaints.add("an edge begins and ends at the same point", region.points[at(a)]);
    ++surplus[at(a)];
    --surplus[at(b)];
  }
  for (std::size_t v = 0; v < surplus.size(); ++v)
    if (surplus[v] != 0) complaints.add("a loop does not close", region.points[v]);
  for (std::size_t e = 0; e < sorted.size(); ++e) {
    const Edge back = {sorted[e][1], sorted[e][0]};
    if ((e > 0 && sorted[e] == sorted[e - 1]) || std::ranges::binary_search(sorted, back))
      complaints.add("an edge is used twice", region.points[at(sorted[e][0])]);
  }
  return complaints;
}

struct Box2 {
  Vec2 low, high;
};

Box2 bounding_box(const std::vector<Vec2>& points) {
  Box2 box{points[0], points[0]};
  for (const Vec2& p : points) {
    box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y)};
    box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y)};
  }
  return box;
}

std::vector<std::int32_t> insertion_order(const std::vector<Vec2>& points) {
  std::vector<Vec3> flat;
  flat.reserve(points.size());
  for (const Vec2& p : points) flat.push_back({p.x, p.y, 0});
  return brio_order(flat);
}

/// Delaunay triangulation of the points and of four corners round them, which come first. Node of
/// point v: node_of[v].
struct Boxed {
  TriangleComplex complex;
  std::vector<std::int32_t> node_of;
  std::vector<std::int32_t> point_of;
};
inline constexpr std::int32_t corners = 4;

Boxed triangulate_points(const std::vector<Vec2>& points, Complaints& complaints) {
  const Box2 box = bounding_box(points);
  // Generous, so that rounding leaves every point strictly inside.
  double margin = std::max(box.high.x - box.low.x, box.high.y - box.low.y);
  margin += 1e-3 * std::max({std::abs(box.low.x), std::abs(box.low.y), std::abs(box.high.x),
                             std::abs(box.high.y), 1e-30});
  Boxed boxed;
  TriangleComplex& complex = boxed.complex;
  complex.add_point({box.low.x - margin, box.low.y - margin});
  complex.add_point({box.high.x + margin, box.low.y - margin});
  complex.add_point({box.high.x + margin, box.high.y + margin});
  complex.add_point({box.low.x - margin, box.high.y + margin});
  complex.set_triangle(complex.add_triangle(), {0, 1, 2});
  complex.set_triangle(complex.add_triangle(), {0, 2, 3});
  complex.glue(edge_handle(0, 1), edge_handle(1, 2));
  for (const EdgeHandle border :
       {edge_handle(0, 0), edge_handle(0, 2), edge_handle(1, 0), edge_handle(1, 1)})
    complex.constrain(border, true);

  boxed.node_of.assign(points.size(), -1);
  boxed.point_of.assign(corners, -1);
  Cavity cavity;
  std::int32_t last = 0;
  for (const std::int32_t v : insertion_order(points)) {
    const Vec2& p = points[at(v)];
    const std::optional<std::int32_t> holder = locate(complex, last, p);
    TF_CHECK(holder);
    if (!find_cavity(complex, *holder, p, cavity)) {
      complaints.add("two points coincide", p);
      continue;
    }
    boxed.node_of[at(v)] = fill_cavity(complex, p, cavity);
    boxed.point_of.push_back(v);
    last = cavity.triangles[0];
  }
  return boxed;
}

enum class Side : std::uint8_t { unknown, inside, outside };

/// Spreads inside and outside from both sides of the directed edges.
std::vector<Side> classify(const Boxed& boxed, const std::vector<Edge>& edges,
                           Complaints& complaints) {
  const TriangleComplex& complex = boxed.complex;
  std::vector<Side> sides(complex.triangles.size(), Side::unknown);
  std::vector<std::int32_t> front;
  const auto claim = [&](std::int32_t t, Side side, std::int32_t a) {
    Side& mine = sides[at(t)];
    if (mine == Side::unknown) {
      mine = side;
      front.push_back(t);
    } else if (mine != side) {
      complaints.add("loops disagree about which side is inside", complex.point(a));
    }
  };
  for (const auto& [a, b] : edges) {
    const std::int32_t from = boxed.node_of[at(a)];
    const EdgeHandle edge = complex.find_edge(from, boxed.node_of[at(b)]);
    TF_CHECK(edge != no_edge);
    const EdgeHandle other = complex.neighbour(triangle_of(edge), edge_of(edge));
    TF_CHECK(other != no_edge);  // the border of the box is not of the region
    claim(triangle_of(edge), Side::inside, from);
    claim(triangle_of(other), Side::outside, from);
    while (!front.empty()) {
      const std::int32_t t = front.back();
      front.pop_back();
      for (int i = 0; i < 3; ++i)
        if (!complex.is_constrained(t, i))
          claim(triangle_of(complex.neighbour(t, i)), sides[at(t)], from);
    }
  }
  for (std::int32_t t = 0; t < complex.size(); ++t)
    for (const std::int32_t v : complex.nodes(t))
      if (v < corners && sides[at(t)] == Side::inside && !complaints.failure)
        complaints.add("the outermost loop runs clockwise", complex.point(complex.node(t, 0)));
  return sides;
}

/// The inside triangles, with the region's numbers.
TriangleComplex keep_inside(const Boxed& boxed, const std::vector<Side>& sides,
                            const std::vector<Vec2>& points) {
  TF_CHECK(sides.size() == boxed.complex.triangles.size());
  std::vector<TriangleComplex::Nodes> triangles;
  for (std::int32_t t = 0; t < boxed.complex.size(); ++t) {
    if (sides[at(t)] != Side::inside) continue;
    const auto& [a, b, c] = boxed.complex.nodes(t);
    triangles.push_back({boxed.point_of[at(a)], boxed.point_of[at(b)], boxed.point_of[at(c)]});
  }
  return make_triangle_complex(points, std::move(triangles));
}

}  // namespace

ConstrainedDelaunay constrained_delaunay(const PlanarRegion& region) {
  std::vector<Edge> edges = region.edges;
  std::ranges::sort(edges);
  Complaints complaints = check_edges(region, edges);
  if (complaints.failure) return {{}, std::move(complaints.failure)};

  Boxed boxed = triangulate_points(region.points, complaints);
  if (complaints.failure) return {{}, std::move(complaints.failure)};
  for (const auto& [a, b] : edges) {
    TF_CHECK(boxed.node_of[at(a)] >= 0 && boxed.node_of[at(b)] >= 0);
    const auto failure = recover_edge(boxed.complex, boxed.node_of[at(a)], boxed.node_of[at(b)]);
    if (failure) complaints.add(failure->reason, failure->where[0]);
  }
  if (complaints.failure) return {{}, std::move(complaints.failure)};

  const std::vector<Side> sides = classify(boxed, edges, complaints);
  if (complaints.failure) return {{}, std::move(complaints.failure)};
  ConstrainedDelaunay result{keep_inside(boxed, sides, region.points), std::nullopt};
  flip_to_delaunay(result.complex);
  return result;
}

}  // namespace tetfarm
