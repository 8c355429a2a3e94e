#include "mesh/adaptation/mesh_location.h"

#include <algorithm>
#include <cmath>

#include "base/array_index.h"
#include "base/check.h"
#include "mesh/geometry/hilbert_order.h"

namespace tetfarm {
namespace {

double doubled_area(const Vec2& a, const Vec2& b, const Vec2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

std::array<double, 3> areas_at(const TriangleComplex& complex, std::int32_t t, const Vec2& p) {
  const TriangleComplex::Nodes& n = complex.nodes(t);
  const Vec2& a = complex.point(n[0]);
  const Vec2& b = complex.point(n[1]);
  const Vec2& c = complex.point(n[2]);
  return {doubled_area(b, c, p), doubled_area(c, a, p), doubled_area(a, b, p)};
}

/// Its two ends, with the domain on the left.
std::array<Vec2, 2> ends_of(const TriangleComplex& complex, EdgeHandle edge) {
  const std::int32_t t = triangle_of(edge);
  const int i = edge_of(edge);
  return {complex.point(complex.node(t, next(i))), complex.point(complex.node(t, previous(i)))};
}

/// The way into the domain, as long as the edge.
Vec2 inward_of(const std::array<Vec2, 2>& ends) {
  return {ends[0].y - ends[1].y, ends[1].x - ends[0].x};
}

Box3 box_round(const Vec2& p, double radius) {
  return {{p.x - radius, p.y - radius, 0}, {p.x + radius, p.y + radius, 0}};
}

std::vector<BorderSide> border_sides(const TriangleComplex& complex) {
  std::vector<BorderSide> sides(complex.points.size());
  for (std::int32_t t = 0; t < complex.size(); ++t) {
    for (int i = 0; i < 3; ++i) {
      if (complex.neighbour(t, i) != no_edge) continue;
      const Vec2 inward = inward_of(ends_of(complex, edge_handle(t, i)));
      const double length = std::hypot(inward.x, inward.y);
      for (const std::int32_t v : {complex.node(t, next(i)), complex.node(t, previous(i))}) {
        BorderSide& side = sides[at(v)];
        side.inward = {side.inward.x + inward.x / length, side.inward.y + inward.y / length};
        side.reach = std::max(side.reach, length / 2);
      }
    }
  }
  return sides;
}

}  // namespace

std::array<double, 3> walk_to(const TriangleComplex& complex, const Vec2& point, std::int32_t& home,
                              int most_steps) {
  TF_CHECK(home >= 0 && home < complex.size());
  EdgeHandle entered = no_edge;
  std::array<double, 3> areas = areas_at(complex, home, point);
  for (int step = 0; step < most_steps; ++step) {
    int worst = -1;
    for (int i = 0; i < 3; ++i) {
      const EdgeHandle beyond = complex.neighbour(home, i);
      if (areas[at(i)] >= 0 || beyond == no_edge || edge_handle(home, i) == entered) continue;
      if (worst < 0 || areas[at(i)] < areas[at(worst)]) worst = i;
    }
    if (worst < 0) break;
    entered = complex.neighbour(home, worst);
    home = triangle_of(entered);
    areas = areas_at(complex, home, point);
  }
  return areas;
}

MeshLocation::MeshLocation(const TriangleComplex& complex) : complex_(complex) {
  TF_CHECK(complex.size() > 0);
  most_steps_ = 100 + static_cast<int>(4 * std::sqrt(complex.size()));
  std::vector<Box3> boxes(at(complex.size()));
  std::vector<Box3> border_boxes;
  double border_length = 0;
  for (std::int32_t t = 0; t < complex.size(); ++t) {
    for (int i = 0; i < 3; ++i) {
      const Vec2& p = complex.point(complex.node(t, i));
      boxes[at(t)].add(Vec3{p.x, p.y, 0});
      if (complex.neighbour(t, i) != no_edge) continue;
      const auto [a, b] = ends_of(complex, edge_handle(t, i));
      border_.push_back(edge_handle(t, i));
      Box3& box = border_boxes.emplace_back();
      box.add(Vec3{a.x, a.y, 0});
      box.add(Vec3{b.x, b.y, 0});
      border_length += std::hypot(b.x - a.x, b.y - a.y);
    }
    box_.add(boxes[at(t)]);
  }
  TF_CHECK(!border_.empty());
  triangles_ = BoxTree(boxes);
  border_tree_ = BoxTree(border_boxes);
  first_radius_ = border_length / static_cast<double>(border_.size()) / 64;
}

bool MeshLocation::holds(std::int32_t triangle, const Vec2& point) const {
  const TriangleComplex::Nodes& n = complex_.nodes(triangle);
  const Vec2& a = complex_.point(n[0]);
  const Vec2& b = complex_.point(n[1]);
  const Vec2& c = complex_.point(n[2]);
  return orient2d(a, b, point) >= 0 && orient2d(b, c, point) >= 0 && orient2d(c, a, point) >= 0;
}

bool MeshLocation::find(const Vec2& point, std::int32_t& hint) const {
  walk_to(complex_, point, hint, most_steps_);
  if (holds(hint, point)) return true;
  std::int32_t found = -1;
  triangles_.query(box_round(point, 0), [&](std::int32_t t) {
    if ((found < 0 || t < found) && holds(t, point)) found = t;
  });
  if (found >= 0) hint = found;
  return found >= 0;
}

MeshLocation::NearEdge MeshLocation::measured(EdgeHandle edge, const Vec2& point) const {
  const auto [a, b] = ends_of(complex_, edge);
  const Vec2 along{b.x - a.x, b.y - a.y};
  const double share = ((point.x - a.x) * along.x + (point.y - a.y) * along.y) /
                       (along.x * along.x + along.y * along.y);
  NearEdge near{edge, std::clamp(share, 0.0, 1.0), 0, orient2d(a, b, point) >= 0};
  // At an end the place is the end itself, so that two edges of a node are equally far.
  const Vec2 place = near.share == 0   ? a
                     : near.share == 1 ? b
                                       : Vec2{a.x + share * along.x, a.y + share * along.y};
  near.square =
      (place.x - point.x) * (place.x - point.x) + (place.y - point.y) * (place.y - point.y);
  return near;
}

MeshLocation::NearEdge MeshLocation::nearest_edge(const Vec2& point, const Vec2& inward) const {
  const double farthest =
      std::hypot(std::max(std::abs(point.x - box_.low.x), std::abs(point.x - box_.high.x)),
                 std::max(std::abs(point.y - box_.low.y), std::abs(point.y - box_.high.y)));
  NearEdge nearest;
  for (double radius = first_radius_;; radius *= 2) {
    border_tree_.query(box_round(point, radius), [&](std::int32_t k) {
      const Vec2 looks = inward_of(ends_of(complex_, border_[at(k)]));
      if (looks.x * inward.x + looks.y * inward.y < 0) return;
      const NearEdge near = measured(border_[at(k)], point);
      if (nearest.edge != no_edge && near.square == nearest.square) {
        nearest.is_beside = nearest.is_beside || near.is_beside;
        if (near.edge > nearest.edge) return;
        const bool is_beside = nearest.is_beside;
        nearest = near;
        nearest.is_beside = is_beside;
      } else if (nearest.edge == no_edge || near.square < nearest.square) {
        nearest = near;
      }
    });
    const bool is_found = nearest.edge != no_edge && nearest.square <= radius * radius;
    if (is_found || radius > farthest) return nearest;
  }
}

PlaneLocation MeshLocation::at_edge(const NearEdge& near) const {
  PlaneLocation place;
  place.triangle = triangle_of(near.edge);
  place.weights[at(next(edge_of(near.edge)))] = 1 - near.share;
  place.weights[at(previous(edge_of(near.edge)))] = near.share;
  place.distance = std::sqrt(near.square);
  return place;
}

PlaneLocation MeshLocation::in_triangle(std::int32_t triangle, std::array<double, 3> areas) const {
  PlaneLocation place;
  place.triangle = triangle;
  double sum = 0;
  for (double& area : areas) {
    area = std::max(area, 0.0);
    sum += area;
  }
  for (std::size_t i = 0; i < 3; ++i) place.weights[i] = sum > 0 ? areas[i] / sum : 1.0 / 3;
  return place;
}

PlaneLocation MeshLocation::locate(const Vec2& point, std::int32_t hint) const {
  if (find(point, hint)) return in_triangle(hint, areas_at(complex_, hint, point));
  const NearEdge near = nearest_edge(point, {0, 0});
  TF_CHECK(near.edge != no_edge);
  return at_edge(near);
}

PlaneLocation MeshLocation::locate_on_border(const Vec2& point, const BorderSide& side,
                                             std::int32_t hint) const {
  const NearEdge near = nearest_edge(point, side.inward);
  const PlaneLocation place = locate(point, hint);
  if (near.edge == no_edge) return place;
  const auto [a, b] = ends_of(complex_, near.edge);
  const double reach = std::max(side.reach, std::hypot(b.x - a.x, b.y - a.y) / 2);
  if (near.square > reach * reach) return place;
  const bool is_inside = near.is_beside && place.distance == 0;
  return is_inside ? place : at_edge(near);
}

std::vector<PlaneLocation> locate_nodes(const MeshLocation& background,
                                        const TriangleComplex& target) {
  const std::vector<BorderSide> sides = border_sides(target);
  std::vector<Vec3> points;
  points.reserve(target.points.size());
  for (const Vec2& p : target.points) points.push_back({p.x, p.y, 0});
  std::vector<PlaneLocation> places(points.size());
  std::int32_t hint = 0;
  for (const std::int32_t v : hilbert_order(points)) {
    const BorderSide& side = sides[at(v)];
    places[at(v)] = side.reach > 0 ? background.locate_on_border(target.point(v), side, hint)
                                   : background.locate(target.point(v), hint);
    hint = places[at(v)].triangle;
  }
  return places;
}

}  // namespace tetfarm
