#include "mesh/arrangement/constrained_triangulation.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <deque>
#include <unordered_set>
#include <utility>

#include "base/array_index.h"
#include "base/check.h"

namespace tetfarm {
namespace {

constexpr std::int32_t nobody = -1;
constexpr std::size_t corner_count = 3;

/// Corners anticlockwise; beyond[k] is the triangle on the other side of the edge against corner k.
struct PlanarTriangle {
  std::array<std::int32_t, corner_count> nodes = {nobody, nobody, nobody};
  std::array<std::int32_t, corner_count> beyond = {nobody, nobody, nobody};
};

/// An edge as the triangle and the corner against it.
struct EdgePlace {
  std::int32_t triangle = nobody;
  std::size_t corner = 0;
};

std::size_t place_of(const std::array<std::int32_t, corner_count>& of, std::int32_t what) {
  const auto found = std::ranges::find(of, what);
  TF_CHECK(found != of.end());
  return static_cast<std::size_t>(found - of.begin());
}

std::uint64_t edge_key(std::int32_t a, std::int32_t b) {
  const auto low = static_cast<std::uint64_t>(std::min(a, b));
  const auto high = static_cast<std::uint64_t>(std::max(a, b));
  return low << 32U | high;
}

/// Three corners far outside the box of the nodes, and what is between.
class Triangulation {
 public:
  Triangulation(const ExactPoints& points, const std::vector<std::int32_t>& nodes, int axis)
      : axis_(axis) {
    Box3 box;
    for (const std::int32_t n : nodes) box.add(points[n].near);
    surround(box);
    for (const std::int32_t n : nodes) points_.push_back(&points[n]);
    triangle_of_.assign(points_.size(), 0);
    triangles_.push_back({{0, 1, 2}, {nobody, nobody, nobody}});
  }

  /// All nodes; false where two are seen at one place.
  bool insert_nodes() {
    for (std::size_t i = corner_count; i < points_.size(); ++i) {
      if (!insert(static_cast<std::int32_t>(i))) return false;
    }
    return true;
  }

  Triangulation(const Triangulation&) = delete;
  Triangulation& operator=(const Triangulation&) = delete;

  /// Between the node at place a of those given and that at place b; false where a node is between.
  bool enforce(std::int32_t a, std::int32_t b) {
    const std::int32_t from = a + static_cast<std::int32_t>(corner_count);
    const std::int32_t to = b + static_cast<std::int32_t>(corner_count);
    std::deque<Segment> crossing;
    if (!find_crossed_edges(from, to, crossing)) return false;
    // Each flip takes a crossing away, or moves it on; a few for each is what it takes.
    std::size_t steps_left = 16 + 4 * crossing.size() * crossing.size();
    while (!crossing.empty()) {
      TF_CHECK(steps_left-- > 0);
      const Segment edge = crossing.front();
      crossing.pop_front();
      const EdgePlace place = find_edge(edge[0], edge[1]);
      if (!can_flip(place)) {
        crossing.push_back(edge);
        continue;
      }
      const Segment made = flip(place);
      if (crosses(from, to, made)) crossing.push_back(made);
    }
    is_fixed_.insert(edge_key(from, to));
    return true;
  }

  /// Flips what makes better triangles.
  void improve() {
    std::vector<EdgePlace> places;
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
      for (std::size_t k = 0; k < corner_count; ++k) {
        places.push_back({static_cast<std::int32_t>(t), k});
      }
    }
    settle(std::move(places));
  }

  /// In places of the nodes given.
  std::vector<Triangle> inner_triangles() const {
    std::vector<Triangle> inner;
    for (const PlanarTriangle& t : triangles_) {
      if (*std::ranges::min_element(t.nodes) < static_cast<std::int32_t>(corner_count)) continue;
      inner.push_back({t.nodes[0] - 3, t.nodes[1] - 3, t.nodes[2] - 3});
    }
    return inner;
  }

 private:
  void surround(const Box3& box) {
    const Vec3 centre = box.centre();
    const double reach =
        16 * (std::max({box.size().x, box.size().y, box.size().z}) +
              1e-9 * (std::abs(centre.x) + std::abs(centre.y) + std::abs(centre.z)));
    const int u = (axis_ + 1) % 3;
    const int v = (axis_ + 2) % 3;
    const std::array<std::array<double, 2>, corner_count> away = {{{-2, -1}, {2, -1}, {0, 2}}};
    for (std::size_t k = 0; k < corner_count; ++k) {
      Vec3 corner = centre;
      corner[u] += away[k][0] * reach;
      corner[v] += away[k][1] * reach;
      outer_[k] = exact_point(corner);
      points_.push_back(&outer_[k]);
    }
  }

  const ExactPoint& point(std::int32_t node) const { return *points_[at(node)]; }
  PlanarTriangle& triangle(std::int32_t t) { return triangles_[at(t)]; }
  const PlanarTriangle& triangle(std::int32_t t) const { return triangles_[at(t)]; }

  int turn(std::int32_t a, std::int32_t b, std::int32_t c) const {
    return seen_turn(point(a), point(b), point(c), axis_);
  }

  /// The sides of the triangle's edges on which a node lies, each against its corner.
  std::array<int, corner_count> sides(std::int32_t t, std::int32_t node) const {
    const auto& n = triangle(t).nodes;
    return {turn(n[1], n[2], node), turn(n[2], n[0], node), turn(n[0], n[1], node)};
  }

  /// The triangle in which or on whose edge the node lies. Walks from the one made last; where that
  /// does not end, looks at all.
  std::int32_t locate(std::int32_t node) const {
    auto t = static_cast<std::int32_t>(triangles_.size()) - 1;
    for (std::size_t step = 0; step < 4 * triangles_.size() + 16; ++step) {
      const std::array<int, corner_count> side = sides(t, node);
      const auto outside = std::ranges::find(side, -1);
      if (outside == side.end()) return t;
      t = triangle(t).beyond[static_cast<std::size_t>(outside - side.begin())];
      TF_CHECK(t != nobody);
    }
    for (t = 0; t < static_cast<std::int32_t>(triangles_.size()); ++t) {
      const std::array<int, corner_count> side = sides(t, node);
      if (std::ranges::find(side, -1) == side.end()) return t;
    }
    TF_CHECK(false);
    return nobody;
  }

  void link(std::int32_t t, std::size_t corner, std::int32_t other, std::int32_t instead_of) {
    triangle(t).beyond[corner] = other;
    if (other != nobody) {
      triangle(other).beyond[place_of(triangle(other).beyond, instead_of)] = t;
    }
  }

  void set_nodes(std::int32_t t, const std::array<std::int32_t, corner_count>& nodes) {
    triangle(t).nodes = nodes;
    for (const std::int32_t n : nodes) triangle_of_[at(n)] = t;
  }

  std::int32_t add_triangle() {
    triangles_.emplace_back();
    return static_cast<std::int32_t>(triangles_.size()) - 1;
  }

  bool insert(std::int32_t node) {
    const std::int32_t t = locate(node);
    const std::array<int, corner_count> side = sides(t, node);
    if (std::ranges::count(side, 0) > 1) return false;
    const auto on = std::ranges::find(side, 0);
    if (on == side.end()) {
      settle(divide_triangle(t, node));
    } else {
      settle(divide_edge({t, static_cast<std::size_t>(on - side.begin())}, node));
    }
    return true;
  }

  std::vector<EdgePlace> divide_triangle(std::int32_t t, std::int32_t node) {
    const PlanarTriangle old = triangle(t);
    const auto [a, b, c] = old.nodes;
    const std::int32_t second = add_triangle();
    const std::int32_t third = add_triangle();
    set_nodes(t, {node, b, c});
    set_nodes(second, {node, c, a});
    set_nodes(third, {node, a, b});
    link(second, 0, old.beyond[1], t);
    link(third, 0, old.beyond[2], t);
    triangle(t).beyond = {old.beyond[0], second, third};
    triangle(second).beyond = {triangle(second).beyond[0], third, t};
    triangle(third).beyond = {triangle(third).beyond[0], t, second};
    return {{t, 0}, {second, 0}, {third, 0}};
  }

  std::vector<EdgePlace> divide_edge(const EdgePlace& edge, std::int32_t node) {
    const std::int32_t t = edge.triangle;
    const PlanarTriangle old = triangle(t);
    const std::size_t k = edge.corner;
    const std::int32_t a = old.nodes[k];
    const std::int32_t b = old.nodes[(k + 1) % corner_count];
    const std::int32_t c = old.nodes[(k + 2) % corner_count];
    const std::int32_t other = old.beyond[k];
    TF_CHECK(other != nobody);
    const PlanarTriangle old_other = triangle(other);
    const std::size_t l = place_of(old_other.beyond, t);
    const std::int32_t d = old_other.nodes[l];
    const std::int32_t half = add_triangle();
    const std::int32_t other_half = add_triangle();
    // t: a b node; half: a node c; other: d node b; other_half: d c node.
    set_nodes(t, {a, b, node});
    set_nodes(half, {a, node, c});
    set_nodes(other, {d, node, b});
    set_nodes(other_half, {d, c, node});
    const std::int32_t across_ca = old.beyond[(k + 1) % corner_count];
    const std::int32_t across_dc = old_other.beyond[(l + 2) % corner_count];
    const std::int32_t across_ab = old.beyond[(k + 2) % corner_count];
    const std::int32_t across_bd = old_other.beyond[(l + 1) % corner_count];
    triangle(t).beyond = {other, half, across_ab};
    triangle(half).beyond = {other_half, nobody, t};
    triangle(other).beyond = {t, across_bd, other_half};
    triangle(other_half).beyond = {half, other, nobody};
    link(half, 1, across_ca, t);
    link(other_half, 2, across_dc, other);
    return {{t, 2}, {half, 1}, {other, 1}, {other_half, 2}};
  }

  /// Whether the two triangles of an edge form a quadrilateral whose other diagonal is inside it.
  bool can_flip(const EdgePlace& edge) const {
    const std::int32_t other = triangle(edge.triangle).beyond[edge.corner];
    if (other == nobody) return false;
    const auto& n = triangle(edge.triangle).nodes;
    const std::int32_t a = n[edge.corner];
    const std::int32_t b = n[(edge.corner + 1) % corner_count];
    const std::int32_t c = n[(edge.corner + 2) % corner_count];
    const std::int32_t d = triangle(other).nodes[place_of(triangle(other).beyond, edge.triangle)];
    return turn(a, b, d) > 0 && turn(a, d, c) > 0;
  }

  /// The edge that is there afterwards. @pre can_flip.
  Segment flip(const EdgePlace& edge) {
    const std::int32_t t = edge.triangle;
    const PlanarTriangle old = triangle(t);
    const std::size_t k = edge.corner;
    const std::int32_t other = old.beyond[k];
    const PlanarTriangle old_other = triangle(other);
    const std::size_t l = place_of(old_other.beyond, t);
    const std::int32_t a = old.nodes[k];
    const std::int32_t b = old.nodes[(k + 1) % corner_count];
    const std::int32_t c = old.nodes[(k + 2) % corner_count];
    const std::int32_t d = old_other.nodes[l];
    set_nodes(t, {a, b, d});
    set_nodes(other, {a, d, c});
    const std::int32_t across_bd = old_other.beyond[(l + 1) % corner_count];
    const std::int32_t across_ca = old.beyond[(k + 1) % corner_count];
    triangle(t).beyond = {nobody, other, old.beyond[(k + 2) % corner_count]};
    triangle(other).beyond = {old_other.beyond[(l + 2) % corner_count], nobody, t};
    link(t, 0, across_bd, other);
    link(other, 1, across_ca, t);
    return {a, d};
  }

  EdgePlace find_edge(std::int32_t a, std::int32_t b) const {
    const std::int32_t first = triangle_of_[at(a)];
    for (const bool anticlockwise : {true, false}) {
      std::int32_t t = first;
      do {
        const auto& n = triangle(t).nodes;
        const std::size_t k = place_of(n, a);
        if (n[(k + 1) % corner_count] == b) return {t, (k + 2) % corner_count};
        if (n[(k + 2) % corner_count] == b) return {t, (k + 1) % corner_count};
        t = triangle(t).beyond[(k + (anticlockwise ? 1 : 2)) % corner_count];
      } while (t != nobody && t != first);
    }
    return {};
  }

  bool crosses(std::int32_t from, std::int32_t to, const Segment& edge) const {
    if (edge[0] == from || edge[0] == to || edge[1] == from || edge[1] == to) return false;
    return turn(from, to, edge[0]) * turn(from, to, edge[1]) < 0 &&
           turn(edge[0], edge[1], from) * turn(edge[0], edge[1], to) < 0;
  }

  /// From one end to the other; none where the edge is there. False where the way runs through a
  /// node.
  bool find_crossed_edges(std::int32_t from, std::int32_t to, std::deque<Segment>& crossed) const {
    if (find_edge(from, to).triangle != nobody) return true;
    EdgePlace place = first_crossed(from, to);
    while (place.triangle != nobody) {
      const auto& n = triangle(place.triangle).nodes;
      const std::int32_t right = n[(place.corner + 1) % corner_count];
      const std::int32_t left = n[(place.corner + 2) % corner_count];
      if (is_fixed_.contains(edge_key(right, left))) return false;
      crossed.push_back({right, left});
      const std::int32_t other = triangle(place.triangle).beyond[place.corner];
      const std::size_t l = place_of(triangle(other).beyond, place.triangle);
      const std::int32_t next = triangle(other).nodes[l];
      if (next == to) return true;
      const int side = turn(from, to, next);
      if (side == 0) return false;
      // Out through the edge that has the next node and the one on the other side of the line.
      place = {other, side > 0 ? (l + 1) % corner_count : (l + 2) % corner_count};
    }
    return false;
  }

  /// Of the triangle round `from` that the way leaves through the edge against it; of none where it
  /// leaves along an edge.
  EdgePlace first_crossed(std::int32_t from, std::int32_t to) const {
    const std::int32_t first = triangle_of_[at(from)];
    std::int32_t t = first;
    do {
      const auto& n = triangle(t).nodes;
      const std::size_t k = place_of(n, from);
      if (turn(from, to, n[(k + 1) % corner_count]) < 0 &&
          turn(from, to, n[(k + 2) % corner_count]) > 0) {
        return {t, k};
      }
      t = triangle(t).beyond[(k + 1) % corner_count];
    } while (t != first);
    return {};
  }

  /// The least sine of an angle, of the points as they are near; 0 where these are turned over.
  double shape(std::int32_t a, std::int32_t b, std::int32_t c) const {
    const int u = (axis_ + 1) % 3;
    const int v = (axis_ + 2) % 3;
    const Vec3& p = point(a).near;
    const Vec3& q = point(b).near;
    const Vec3& r = point(c).near;
    const double area = (p[u] - r[u]) * (q[v] - r[v]) - (p[v] - r[v]) * (q[u] - r[u]);
    const auto side = [&](const Vec3& x, const Vec3& y) {
      return std::sqrt((x[u] - y[u]) * (x[u] - y[u]) + (x[v] - y[v]) * (x[v] - y[v]));
    };
    std::array<double, corner_count> sides = {side(p, q), side(q, r), side(r, p)};
    std::ranges::sort(sides);
    return area > 0 ? area / (sides[1] * sides[2]) : 0;
  }

  /// By so much that flips must come to an end.
  bool is_better_flipped(const EdgePlace& edge) const {
    constexpr double gain = 1e-6;
    const auto& n = triangle(edge.triangle).nodes;
    const std::int32_t other = triangle(edge.triangle).beyond[edge.corner];
    const std::int32_t a = n[edge.corner];
    const std::int32_t b = n[(edge.corner + 1) % corner_count];
    const std::int32_t c = n[(edge.corner + 2) % corner_count];
    const std::int32_t d = triangle(other).nodes[place_of(triangle(other).beyond, edge.triangle)];
    const double now = std::min(shape(a, b, c), shape(d, c, b));
    const double then = std::min(shape(a, b, d), shape(a, d, c));
    return then > (1 + gain) * now + 1e-12;
  }

  void settle(std::vector<EdgePlace> places) {
    while (!places.empty()) {
      const EdgePlace place = places.back();
      places.pop_back();
      const auto& n = triangle(place.triangle).nodes;
      const std::int32_t b = n[(place.corner + 1) % corner_count];
      const std::int32_t c = n[(place.corner + 2) % corner_count];
      const std::int32_t other = triangle(place.triangle).beyond[place.corner];
      if (other == nobody || is_fixed_.contains(edge_key(b, c))) continue;
      if (!is_better_flipped(place) || !can_flip(place)) continue;
      flip(place);
      for (const std::int32_t t : {place.triangle, other}) {
        for (std::size_t k = 0; k < corner_count; ++k) places.push_back({t, k});
      }
    }
  }

  int axis_;
  std::array<ExactPoint, corner_count> outer_;
  std::vector<const ExactPoint*> points_;
  std::vector<PlanarTriangle> triangles_;
  std::vector<std::int32_t> triangle_of_;
  std::unordered_set<std::uint64_t> is_fixed_;
};

}  // namespace

std::optional<std::vector<Triangle>> triangulate(const ExactPoints& points,
                                                 const std::vector<std::int32_t>& nodes,
                                                 const std::vector<Segment>& edges, int axis) {
  std::vector<std::int32_t> sorted = nodes;
  std::ranges::sort(sorted);
  const auto place = [&](std::int32_t node) {
    const auto found = std::ranges::lower_bound(sorted, node);
    TF_CHECK(found != sorted.end() && *found == node);
    return static_cast<std::int32_t>(found - sorted.begin());
  };
  Triangulation triangulation(points, sorted, axis);
  if (!triangulation.insert_nodes()) return std::nullopt;
  for (const Segment& edge : edges) {
    if (!triangulation.enforce(place(edge[0]), place(edge[1]))) return std::nullopt;
  }
  triangulation.improve();
  std::vector<Triangle> triangles = triangulation.inner_triangles();
  for (Triangle& t : triangles) {
    for (std::int32_t& n : t) n = sorted[at(n)];
  }
  return triangles;
}

}  // namespace tetfarm
