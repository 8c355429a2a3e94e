#include "mesh/adaptation/ellipse_cavity.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/array_index.h"
#include "base/check.h"

namespace tetfarm {
namespace {

constexpr std::size_t most_triangles = 200;

/// The distance of the origin from the centre of the ellipse through three points, over its radius.
double ellipse_ratio(const std::array<Vec2, 3>& corners, const Metric2& m) {
  // With m = Lᵀ L the points L c lie on a circle.
  const double p = std::sqrt(m.xx);
  const double q = m.xy / p;
  const double r = std::sqrt(std::max(m.yy - q * q, 0.0));
  std::array<Vec2, 3> c;
  for (std::size_t i = 0; i < 3; ++i) {
    c[i] = {p * corners[i].x + q * corners[i].y, r * corners[i].y};
  }
  const Vec2 u{c[1].x - c[0].x, c[1].y - c[0].y};
  const Vec2 v{c[2].x - c[0].x, c[2].y - c[0].y};
  const double doubled = 2 * (u.x * v.y - u.y * v.x);
  const double uu = u.x * u.x + u.y * u.y;
  const double vv = v.x * v.x + v.y * v.y;
  const Vec2 centre{(v.y * uu - u.y * vv) / doubled, (u.x * vv - v.x * uu) / doubled};
  const double radius = centre.x * centre.x + centre.y * centre.y;
  const double dx = centre.x + c[0].x;
  const double dy = centre.y + c[0].y;
  return std::sqrt((dx * dx + dy * dy) / radius);
}

}  // namespace

bool is_in_ellipse(const MetricMesh& mesh, const TriangleComplex::Nodes& nodes, int apex,
                   const NodePlace& p, EllipseTest test) {
  std::array<Vec2, 3> corners;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec2& at_corner = mesh.complex.point(nodes[i]);
    corners[i] = {at_corner.x - p.point.x, at_corner.y - p.point.y};
  }
  double sum = ellipse_ratio(corners, p.metric);
  if (test == EllipseTest::at_new_node) return sum < 1;
  if (test == EllipseTest::at_apex_too) {
    return sum + ellipse_ratio(corners, mesh.metrics[at(nodes[at(apex)])]) < 2;
  }
  for (const std::int32_t node : nodes) sum += ellipse_ratio(corners, mesh.metrics[at(node)]);
  return sum < 4;
}

bool EllipseCavity::mark_rim_node(std::int32_t node) {
  if (node_stamps_[at(node)] == stamp_) return false;
  node_stamps_[at(node)] = stamp_;
  rim_nodes_.push_back(node);
  return true;
}

bool EllipseCavity::is_seen(const MetricMesh& mesh, const NodePlace& place, EdgeHandle edge) const {
  const std::int32_t t = triangle_of(edge);
  const int i = edge_of(edge);
  return orient2d(mesh.complex.point(mesh.complex.node(t, next(i))),
                  mesh.complex.point(mesh.complex.node(t, previous(i))), place.point) > 0;
}

void EllipseCavity::add(std::int32_t triangle, int ring) {
  triangle_stamps_[at(triangle)] = stamp_;
  triangles_.push_back(triangle);
  rings_.push_back(ring);
}

bool EllipseCavity::open(const MetricMesh& mesh, const NodePlace& place, EdgeHandle edge) {
  TF_CHECK(edge != no_edge && mesh.is_used(triangle_of(edge)));
  ++stamp_;
  const std::size_t nodes = mesh.complex.points.size();
  if (node_stamps_.size() < nodes + 1) {
    node_stamps_.resize(nodes + nodes / 4 + 64, 0);
    starts_.resize(nodes + nodes / 4 + 64, -1);
  }
  const std::size_t triangles = mesh.complex.triangles.size();
  if (triangle_stamps_.size() < triangles) {
    triangle_stamps_.resize(triangles + triangles / 4 + 64, 0);
  }
  triangles_.clear();
  rings_.clear();
  rim_nodes_.clear();
  divided_ = edge;
  const std::int32_t t = triangle_of(edge);
  add(t, 0);
  for (const std::int32_t node : mesh.complex.nodes(t)) mark_rim_node(node);
  const EdgeHandle other = mesh.complex.neighbour(t, edge_of(edge));
  if (other != no_edge) {
    add(triangle_of(other), 0);
    // Two triangles on the same three nodes do not occur in a plane mesh.
    mark_rim_node(mesh.complex.node(triangle_of(other), edge_of(other)));
  }
  return grow_until_seen(mesh, place);
}

/// A node on a curve may lie beyond the triangles of its edge: the cavity takes in what is in
/// between.
bool EllipseCavity::grow_until_seen(const MetricMesh& mesh, const NodePlace& place) {
  const EdgeHandle beyond = mesh.complex.neighbour(triangle_of(divided_), edge_of(divided_));
  for (std::size_t k = 0; k < triangles_.size(); ++k) {
    if (k > 64) return false;
    const std::int32_t t = triangles_[k];
    for (int i = 0; i < 3; ++i) {
      const EdgeHandle edge = edge_handle(t, i);
      if (edge == divided_ || edge == beyond) continue;
      const EdgeHandle outside = mesh.complex.neighbour(t, i);
      if (outside != no_edge && triangle_stamps_[at(triangle_of(outside))] == stamp_) continue;
      if (is_seen(mesh, place, edge)) continue;
      if (outside == no_edge || mesh.complex.is_constrained(t, i)) return false;
      const std::int32_t apex = mesh.complex.node(triangle_of(outside), edge_of(outside));
      if (!mark_rim_node(apex)) return false;
      add(triangle_of(outside), 0);
    }
  }
  return true;
}

bool EllipseCavity::find(const MetricMesh& mesh, const NodePlace& place, EdgeHandle edge,
                         double shortest) {
  if (!open(mesh, place, edge)) return false;
  const auto is_too_near = [&](std::int32_t node) {
    return shortest > 0 && edge_length(mesh, place, node) < shortest;
  };
  if (std::any_of(rim_nodes_.begin(), rim_nodes_.end(), is_too_near)) return false;
  const EdgeHandle beyond = mesh.complex.neighbour(triangle_of(edge), edge_of(edge));
  rim_.clear();
  for (std::size_t k = 0; k < triangles_.size(); ++k) {
    const std::int32_t t = triangles_[k];
    for (int i = 0; i < 3; ++i) {
      const EdgeHandle outside = mesh.complex.neighbour(t, i);
      if (edge_handle(t, i) == edge || edge_handle(t, i) == beyond) continue;
      const bool is_constrained = mesh.complex.is_constrained(t, i);
      if (outside != no_edge && triangle_stamps_[at(triangle_of(outside))] == stamp_) continue;
      if (outside != no_edge && !is_constrained && rings_[k] < options_.rings &&
          triangles_.size() < most_triangles) {
        const std::int32_t u = triangle_of(outside);
        const int entry = edge_of(outside);
        const std::int32_t apex = mesh.complex.node(u, entry);
        if (node_stamps_[at(apex)] != stamp_ &&
            is_in_ellipse(mesh, mesh.complex.nodes(u), entry, place, options_.test) &&
            is_seen(mesh, place, edge_handle(u, next(entry))) &&
            is_seen(mesh, place, edge_handle(u, previous(entry)))) {
          if (is_too_near(apex)) return false;
          mark_rim_node(apex);
          add(u, rings_[k] + 1);
          continue;
        }
      }
      rim_.push_back({mesh.complex.node(t, next(i)), mesh.complex.node(t, previous(i)), outside,
                      mesh.regions[at(t)], is_constrained});
    }
  }
  return true;
}

void EllipseCavity::fill(MetricMesh& mesh, std::int32_t node) {
  TF_CHECK(divided_ != no_edge && node == mesh.nodes() - 1);
  const std::int32_t split_t = triangle_of(divided_);
  const int split_i = edge_of(divided_);
  const bool is_constrained = mesh.complex.is_constrained(split_t, split_i);
  const std::int32_t a = mesh.complex.node(split_t, next(split_i));
  const std::int32_t b = mesh.complex.node(split_t, previous(split_i));
  std::size_t taken = 0;
  for (RimEdge& edge : rim_) {
    const std::int32_t t = taken < triangles_.size() ? triangles_[taken++] : take_triangle(mesh);
    mesh.complex.set_triangle(t, {node, edge.from, edge.to});
    mesh.regions[at(t)] = edge.region;
    note_change(mesh, t);
    mesh.complex.glue(edge_handle(t, 0), edge.outside);
    if (edge.is_constrained) mesh.complex.constrain(edge_handle(t, 0), true);
    starts_[at(edge.from)] = t;
    edge.outside = t;
    mesh.active[at(edge.from)] = 1;
    mesh.touched[at(edge.from)] |= TouchedBits::now;
  }
  TF_CHECK(taken == triangles_.size());
  for (const RimEdge& edge : rim_) {
    const std::int32_t here = edge.outside;
    // Where the node divides the border nothing begins at the end of the last triangle.
    const std::int32_t beyond = starts_[at(edge.to)];
    if (beyond >= 0) mesh.complex.glue(edge_handle(here, 1), edge_handle(beyond, 2));
  }
  for (const RimEdge& edge : rim_) starts_[at(edge.from)] = -1;
  if (!is_constrained) return;
  const std::int32_t curve = curve_of_edge(mesh, a, b);
  mesh.curve_of_edge.erase(edge_key(a, b));
  for (const std::int32_t end : {a, b}) {
    mesh.curve_of_edge[edge_key(end, node)] = curve;
    const EdgeHandle forward = mesh.complex.find_edge(node, end);
    mesh.complex.constrain(forward != no_edge ? forward : mesh.complex.find_edge(end, node), true);
  }
}

}  // namespace tetfarm
