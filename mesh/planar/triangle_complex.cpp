#include "mesh/planar/triangle_complex.h"

#include <algorithm>

#include "base/array_index.h"
#include "base/check.h"
#include "mesh/planar/side_buckets.h"

namespace tetfarm {

std::int32_t TriangleComplex::add_point(const Vec2& p) {
  points.push_back(p);
  node2triangle.push_back(-1);
  return static_cast<std::int32_t>(points.size()) - 1;
}

std::int32_t TriangleComplex::add_triangle() {
  TF_CHECK(triangles.size() < (1U << 29U));
  triangles.push_back({-1, -1, -1});
  neighbours.push_back({no_edge, no_edge, no_edge});
  constrained.push_back(0);
  return size() - 1;
}

void TriangleComplex::set_triangle(std::int32_t t, const Nodes& nodes) {
  triangles[at(t)] = nodes;
  neighbours[at(t)] = {no_edge, no_edge, no_edge};
  constrained[at(t)] = 0;
  for (const std::int32_t v : nodes) node2triangle[at(v)] = t;
}

void TriangleComplex::glue(EdgeHandle a, EdgeHandle b) {
  TF_CHECK(a != no_edge);
  neighbours[at(triangle_of(a))][at(edge_of(a))] = b;
  if (b != no_edge) neighbours[at(triangle_of(b))][at(edge_of(b))] = a;
}

void TriangleComplex::constrain(EdgeHandle edge, bool on) {
  const auto mark = [&](EdgeHandle side) {
    std::uint8_t& flags = constrained[at(triangle_of(side))];
    const int bit = 1 << edge_of(side);
    flags = static_cast<std::uint8_t>(on ? flags | bit : flags & ~bit);
  };
  mark(edge);
  const EdgeHandle other = neighbour(triangle_of(edge), edge_of(edge));
  if (other != no_edge) mark(other);
}

EdgeHandle TriangleComplex::find_edge(std::int32_t a, std::int32_t b) const {
  const std::int32_t first = node2triangle[at(a)];
  if (first < 0) return no_edge;
  std::int32_t t = first;
  int local = local_node(t, a);
  // Anticlockwise round a; at a border, start again from the first triangle the other way.
  do {
    if (node(t, next(local)) == b) return edge_handle(t, previous(local));
    const EdgeHandle onward = neighbour(t, next(local));
    if (onward == no_edge) break;
    t = triangle_of(onward);
    local = next(edge_of(onward));
  } while (t != first);
  if (t == first && neighbour(t, next(local)) != no_edge) return no_edge;

  t = first;
  local = local_node(t, a);
  for (;;) {
    const EdgeHandle onward = neighbour(t, previous(local));
    if (onward == no_edge) return no_edge;
    t = triangle_of(onward);
    local = previous(edge_of(onward));
    if (t == first) return no_edge;
    if (node(t, next(local)) == b) return edge_handle(t, previous(local));
  }
}

void TriangleComplex::flip(EdgeHandle edge) {
  const std::int32_t t = triangle_of(edge);
  const int i = edge_of(edge);
  const EdgeHandle other = neighbour(t, i);
  TF_CHECK(other != no_edge && !is_constrained(t, i));
  const std::int32_t u = triangle_of(other);
  const int j = edge_of(other);
  const std::int32_t p = node(t, i);
  const std::int32_t a = node(t, next(i));
  const std::int32_t q = node(u, j);
  const std::int32_t b = node(u, next(j));

  struct Side {
    EdgeHandle outside;
    bool is_constrained;
  };
  const auto side = [&](std::int32_t triangle, int local) {
    return Side{neighbour(triangle, local), is_constrained(triangle, local)};
  };
  const Side bp = side(t, next(i));
  const Side pa = side(t, previous(i));
  const Side aq = side(u, next(j));
  const Side qb = side(u, previous(j));

  set_triangle(t, {p, a, q});
  set_triangle(u, {p, q, b});
  glue(edge_handle(t, 1), edge_handle(u, 2));
  const auto attach = [&](EdgeHandle inside, const Side& s) {
    glue(inside, s.outside);
    if (s.is_constrained) constrain(inside, true);
  };
  attach(edge_handle(t, 2), pa);
  attach(edge_handle(t, 0), aq);
  attach(edge_handle(u, 0), qb);
  attach(edge_handle(u, 1), bp);
}

namespace {

/// Each side with the next on the same two nodes, in the order of their handles.
void pair_sides(TriangleComplex& complex) {
  struct Side {
    std::int32_t high;
    EdgeHandle handle;
    auto operator<=>(const Side&) const = default;
  };
  const SideBuckets buckets(complex.points.size(), complex.triangles,
                            [](std::int32_t a, std::int32_t b) { return std::min(a, b); });
  std::vector<Side> sides;
  for (std::size_t low = 0; low < buckets.nodes(); ++low) {
    sides.clear();
    for (const EdgeHandle side : buckets.of(low)) {
      const std::int32_t t = triangle_of(side);
      sides.push_back(
          {std::max(complex.node(t, next(edge_of(side))), complex.node(t, previous(edge_of(side)))),
           side});
    }
    std::sort(sides.begin(), sides.end());
    for (std::size_t k = 0; k < sides.size(); ++k) {
      if (k + 1 < sides.size() && sides[k].high == sides[k + 1].high) {
        complex.glue(sides[k].handle, sides[k + 1].handle);
        ++k;
      } else {
        complex.constrain(sides[k].handle, true);
      }
    }
  }
}

}  // namespace

TriangleComplex make_triangle_complex(std::vector<Vec2> points,
                                      std::vector<TriangleComplex::Nodes> triangles) {
  TF_CHECK(triangles.size() < (1U << 29U));
  TriangleComplex complex;
  complex.points = std::move(points);
  complex.node2triangle.assign(complex.points.size(), -1);
  complex.triangles = std::move(triangles);
  complex.neighbours.assign(complex.triangles.size(), {no_edge, no_edge, no_edge});
  complex.constrained.assign(complex.triangles.size(), 0);

  for (std::int32_t t = 0; t < complex.size(); ++t) {
    for (const std::int32_t v : complex.nodes(t)) complex.node2triangle[at(v)] = t;
  }
  pair_sides(complex);
  return complex;
}

std::vector<std::array<std::int32_t, 2>> edges_of(const TriangleComplex& complex) {
  std::vector<std::array<std::int32_t, 2>> edges;
  for (std::int32_t t = 0; t < complex.size(); ++t) {
    for (int i = 0; i < 3; ++i) {
      const EdgeHandle other = complex.neighbour(t, i);
      if (other != no_edge && triangle_of(other) < t) continue;
      edges.push_back({complex.node(t, next(i)), complex.node(t, previous(i))});
    }
  }
  return edges;
}

std::vector<std::string> validate(const TriangleComplex& complex) {
  std::vector<std::string> wrong;
  const auto report = [&](std::int32_t t, const std::string& what) {
    if (wrong.size() < 20) wrong.push_back("triangle " + std::to_string(t) + ": " + what);
  };
  const auto is_node = [&](std::int32_t v) { return v >= 0 && at(v) < complex.points.size(); };
  for (std::int32_t t = 0; t < complex.size(); ++t) {
    const auto& [a, b, c] = complex.nodes(t);
    if (!is_node(a) || !is_node(b) || !is_node(c)) {
      report(t, "a node does not exist");
      continue;
    }
    if (!(orient2d(complex.point(a), complex.point(b), complex.point(c)) > 0))
      report(t, "not anticlockwise");
    for (int i = 0; i < 3; ++i) {
      const EdgeHandle other = complex.neighbour(t, i);
      if (other == no_edge) {
        if (!complex.is_constrained(t, i)) report(t, "border edge is not constrained");
        continue;
      }
      const std::int32_t u = triangle_of(other);
      const int j = edge_of(other);
      if (u < 0 || u >= complex.size() || j > 2) {
        report(t, "neighbour does not exist");
      } else if (complex.neighbour(u, j) != edge_handle(t, i)) {
        report(t, "neighbour does not point back");
      } else if (complex.node(u, next(j)) != complex.node(t, previous(i)) ||
                 complex.node(u, previous(j)) != complex.node(t, next(i))) {
        report(t, "neighbour has another edge");
      } else if (complex.is_constrained(u, j) != complex.is_constrained(t, i)) {
        report(t, "sides disagree on a constrained edge");
      }
    }
  }
  for (std::size_t v = 0; v < complex.points.size(); ++v) {
    const std::int32_t t = complex.node2triangle[v];
    if (t < 0) continue;
    const bool holds = t < complex.size() &&
                       std::ranges::count(complex.nodes(t), static_cast<std::int32_t>(v)) == 1;
    if (!holds) report(t, "node " + std::to_string(v) + " is not in its triangle");
  }
  return wrong;
}

}  // namespace tetfarm
