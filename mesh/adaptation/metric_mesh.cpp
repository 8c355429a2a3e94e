#include "mesh/adaptation/metric_mesh.h"

#include <algorithm>
#include <cmath>

#include "base/array_index.h"
#include "base/check.h"
#include "mesh/core/complaints.h"

namespace tetfarm {
namespace {

void validate_boundary(const MetricMesh& mesh, Complaints& wrong) {
  std::size_t constrained = 0;
  for (std::int32_t t = 0; t < mesh.complex.size(); ++t) {
    if (!mesh.is_used(t)) continue;
    for (int i = 0; i < 3; ++i) {
      if (!mesh.complex.is_constrained(t, i)) continue;
      const std::int32_t a = mesh.complex.node(t, next(i));
      const std::int32_t b = mesh.complex.node(t, previous(i));
      const bool seen_before = mesh.complex.neighbour(t, i) != no_edge && a > b;
      constrained += seen_before ? 0 : 1;
      if (curve_of_edge(mesh, a, b) < 0) wrong.add("a constrained edge is on no curve");
    }
  }
  if (constrained != mesh.curve_of_edge.size()) wrong.add("an edge of a curve is missing");
}

void validate_energies(const MetricMesh& mesh, Complaints& wrong) {
  for (std::int32_t t = 0; t < mesh.complex.size() && !wrong.full(); ++t) {
    const float energy = mesh.energies[at(t)];
    if (!mesh.is_used(t) || energy < 0) continue;
    const double right = noted_energy(triangle_energy(mesh, mesh.complex.nodes(t)));
    if (std::abs(energy - right) <= 1e-5 * right) continue;
    wrong.add("triangle " + std::to_string(t) + " has another energy than is noted");
  }
}

}  // namespace

void begin_round(MetricMesh& mesh) {
  for (std::uint8_t& bits : mesh.touched) {
    bits = (bits & TouchedBits::now) != 0 ? TouchedBits::before : 0;
  }
}

void note_change(MetricMesh& mesh, std::int32_t triangle) {
  mesh.energies[at(triangle)] = MetricMesh::unknown_energy;
  mesh.unchecked[at(triangle)] = 0xff;
}

std::uint64_t edge_key(std::int32_t a, std::int32_t b) {
  const auto low = static_cast<std::uint64_t>(std::min(a, b));
  return low << 32U | static_cast<std::uint64_t>(std::max(a, b));
}

std::int32_t curve_of_edge(const MetricMesh& mesh, std::int32_t a, std::int32_t b) {
  const auto found = mesh.curve_of_edge.find(edge_key(a, b));
  return found == mesh.curve_of_edge.end() ? -1 : found->second;
}

double parameter_on(const MetricMesh& mesh, std::int32_t curve, std::int32_t node, double near) {
  if (mesh.curve_of_node[at(node)] == curve) return mesh.parameters[at(node)];
  const BoundaryCurve& shape = mesh.curves[at(curve)].shape;
  const Vec2& point = mesh.complex.point(node);
  const bool begins = shape.at(0) == point;
  const bool ends = shape.at(shape.length()) == point;
  TF_CHECK(begins || ends);
  if (begins && ends) return near < shape.length() / 2 ? 0 : shape.length();
  return begins ? 0 : shape.length();
}

std::int32_t add_node(MetricMesh& mesh, const NodePlace& place) {
  mesh.complex.add_point(place.point);
  mesh.metrics.push_back(place.metric);
  mesh.homes.push_back(place.home);
  mesh.curve_of_node.push_back(MetricMesh::inside);
  mesh.parameters.push_back(0);
  mesh.active.push_back(1);
  mesh.touched.push_back(TouchedBits::now);
  return mesh.nodes() - 1;
}

void move_node(MetricMesh& mesh, std::int32_t node, const NodePlace& place) {
  mesh.complex.points[at(node)] = place.point;
  mesh.metrics[at(node)] = place.metric;
  mesh.homes[at(node)] = place.home;
}

std::int32_t take_triangle(MetricMesh& mesh) {
  if (!mesh.unused.empty()) {
    const std::int32_t t = mesh.unused.back();
    mesh.unused.pop_back();
    return t;
  }
  mesh.regions.push_back(0);
  mesh.energies.push_back(MetricMesh::unknown_energy);
  mesh.unchecked.push_back(0);
  return mesh.complex.add_triangle();
}

void drop_triangle(MetricMesh& mesh, std::int32_t triangle) {
  TF_CHECK(mesh.is_used(triangle));
  mesh.complex.triangles[at(triangle)] = {-1, -1, -1};
  mesh.complex.neighbours[at(triangle)] = {no_edge, no_edge, no_edge};
  mesh.complex.constrained[at(triangle)] = 0;
  mesh.unused.push_back(triangle);
}

void collect_ball(const TriangleComplex& complex, std::int32_t node, Ball& ball) {
  ball.corners.clear();
  ball.is_closed = true;
  const std::int32_t first = complex.node2triangle[at(node)];
  TF_CHECK(first >= 0);
  std::int32_t t = first;
  int local = complex.local_node(t, node);
  do {
    ball.corners.push_back(edge_handle(t, local));
    const EdgeHandle onward = complex.neighbour(t, next(local));
    if (onward == no_edge) {
      ball.is_closed = false;
      break;
    }
    t = triangle_of(onward);
    local = next(edge_of(onward));
  } while (t != first);
  if (ball.is_closed) return;
  // From the border on: those on the other side of the first come before it.
  const auto from_first = static_cast<std::ptrdiff_t>(ball.corners.size());
  t = first;
  local = complex.local_node(t, node);
  for (;;) {
    const EdgeHandle back = complex.neighbour(t, previous(local));
    if (back == no_edge) break;
    t = triangle_of(back);
    local = previous(edge_of(back));
    ball.corners.push_back(edge_handle(t, local));
  }
  std::reverse(ball.corners.begin() + from_first, ball.corners.end());
  std::rotate(ball.corners.begin(), ball.corners.begin() + from_first, ball.corners.end());
}

bool sees_ball(const TriangleComplex& complex, const Ball& ball, const Vec2& point) {
  return std::all_of(ball.corners.begin(), ball.corners.end(), [&](EdgeHandle corner) {
    const OppositeEdge edge = opposite_edge(complex, corner);
    return orient2d(point, complex.point(edge.before), complex.point(edge.after)) > 0;
  });
}

std::vector<std::string> validate(const MetricMesh& mesh) {
  Complaints wrong;
  const TriangleComplex& complex = mesh.complex;
  for (std::int32_t t = 0; t < complex.size() && !wrong.full(); ++t) {
    if (!mesh.is_used(t)) continue;
    const TriangleComplex::Nodes& n = complex.nodes(t);
    if (orient2d(complex.point(n[0]), complex.point(n[1]), complex.point(n[2])) <= 0) {
      wrong.add("triangle " + std::to_string(t) + " does not turn anticlockwise");
    }
    for (int i = 0; i < 3; ++i) {
      const EdgeHandle other = complex.neighbour(t, i);
      if (other == no_edge) {
        if (!complex.is_constrained(t, i)) wrong.add("a border edge is not constrained");
        continue;
      }
      const std::int32_t u = triangle_of(other);
      if (complex.neighbour(u, edge_of(other)) != edge_handle(t, i) ||
          complex.node(u, next(edge_of(other))) != n[at(previous(i))] ||
          complex.node(u, previous(edge_of(other))) != n[at(next(i))]) {
        wrong.add("triangles " + std::to_string(t) + " and " + std::to_string(u) +
                  " do not agree about their edge");
      }
    }
  }
  validate_boundary(mesh, wrong);
  validate_energies(mesh, wrong);
  return wrong.take();
}

}  // namespace tetfarm
