#include "mesh/adaptation/checked_plane_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "base/array_index.h"
#include "base/check.h"
#include "base/error.h"
#include "mesh/adaptation/curve_tracing.h"
#include "mesh/core/vec3.h"
#include "mesh/geometry/hilbert_order.h"
#include "mesh/planar/side_buckets.h"

namespace tetfarm {
namespace {

std::string triangle_text(const PlaneMesh& mesh, std::size_t t) {
  std::string text = in_file(mesh.name, "triangle ") + std::to_string(t + 1) + ", nodes";
  for (const std::int32_t v : mesh.triangles[t]) text += " " + std::to_string(v + 1);
  return text + " at " + place_text(mesh.points[at(mesh.triangles[t][0])]);
}

void check_points(const PlaneMesh& mesh) {
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    const Vec2& p = mesh.points[i];
    if (std::isfinite(p.x) && std::isfinite(p.y) && std::abs(p.x) < 1e60 && std::abs(p.y) < 1e60) {
      continue;
    }
    throw InvalidInput("the coordinates are no usable numbers",
                       in_file(mesh.name, "node " + std::to_string(i + 1)));
  }
}

/// The triangle, anticlockwise.
TriangleComplex::Nodes checked_triangle(const PlaneMesh& mesh, std::size_t t) {
  TriangleComplex::Nodes nodes = mesh.triangles[t];
  for (const std::int32_t v : nodes) {
    if (v < 0 || at(v) >= mesh.points.size()) {
      throw InvalidInput("there is no node " + std::to_string(v + 1) + "; the mesh has " +
                             std::to_string(mesh.points.size()),
                         in_file(mesh.name, "triangle " + std::to_string(t + 1)));
    }
  }
  const double turn =
      orient2d(mesh.points[at(nodes[0])], mesh.points[at(nodes[1])], mesh.points[at(nodes[2])]);
  if (turn == 0) throw InvalidInput("the triangle has no area", triangle_text(mesh, t));
  if (turn < 0) std::swap(nodes[1], nodes[2]);
  return nodes;
}

/// Each edge has at most two triangles, one on each side.
void check_edges(const PlaneMesh& mesh, const std::vector<TriangleComplex::Nodes>& triangles) {
  const SideBuckets buckets(mesh.points.size(), triangles,
                            [](std::int32_t from, std::int32_t /*to*/) { return from; });
  std::vector<std::pair<std::int32_t, std::int32_t>> ends;  // with their triangles
  for (std::size_t from = 0; from < buckets.nodes(); ++from) {
    ends.clear();
    for (const EdgeHandle side : buckets.of(from)) {
      const std::int32_t t = triangle_of(side);
      ends.emplace_back(triangles[at(t)][at(previous(edge_of(side)))], t);
    }
    std::sort(ends.begin(), ends.end());
    const auto twice = std::adjacent_find(
        ends.begin(), ends.end(), [](const auto& a, const auto& b) { return a.first == b.first; });
    if (twice == ends.end()) continue;
    throw InvalidInput("lies over triangle " + std::to_string((twice + 1)->second + 1) +
                           ": both are on the same side of an edge that they share",
                       triangle_text(mesh, at(twice->second)));
  }
}

/// The piece of boundary becomes a curve of the mesh: a part of that of its patch, or the spline
/// through its nodes.
void add_curve(MetricMesh& mesh, const BoundaryPiece& piece, std::span<const PatchCurve> curves) {
  const auto number = static_cast<std::int32_t>(mesh.curves.size());
  std::vector<Vec2> points;
  points.reserve(piece.nodes.size());
  for (const std::int32_t v : piece.nodes) points.push_back(mesh.complex.point(v));
  const PatchCurve* of_patch = curve_of_patch(curves, piece.patch);
  BoundaryCurve shape = of_patch == nullptr ? BoundaryCurve(std::move(points), piece.is_closed)
                                            : boundary_curve_of(*of_patch, points, piece.is_closed);
  for (std::size_t i = 0; i < piece.nodes.size(); ++i) {
    const std::int32_t v = piece.nodes[i];
    const bool is_last = i + 1 == piece.nodes.size();
    mesh.curve_of_node[at(v)] = number;
    mesh.parameters[at(v)] = shape.parameter_of(i);
    if (is_last && !piece.is_closed) continue;
    mesh.curve_of_edge[edge_key(v, piece.nodes[is_last ? 0 : i + 1])] = number;
  }
  mesh.curves.push_back({std::move(shape), piece.patch});
}

/// The triangles in use along the Hilbert curve of their first nodes.
std::vector<std::int32_t> triangles_in_order(const MetricMesh& mesh) {
  std::vector<std::int32_t> used;
  used.reserve(mesh.complex.triangles.size());
  for (std::int32_t t = 0; t < mesh.complex.size(); ++t) {
    if (mesh.is_used(t)) used.push_back(t);
  }
  std::vector<std::int32_t> order = hilbert_order(used.size(), [&](std::size_t k) {
    Vec2 sum;
    for (const std::int32_t v : mesh.complex.nodes(used[k])) {
      sum.x += mesh.complex.point(v).x;
      sum.y += mesh.complex.point(v).y;
    }
    return Vec3{sum.x / 3, sum.y / 3, 0};
  });
  for (std::int32_t& k : order) k = used[at(k)];
  return order;
}

}  // namespace

std::string in_file(const std::string& name, const std::string& what) {
  return name.empty() ? what : name + ": " + what;
}

std::string place_text(const Vec2& p) {
  std::array<char, 80> text{};
  std::snprintf(text.data(), text.size(), "(%.12g, %.12g)", p.x, p.y);
  return text.data();
}

TriangleComplex checked_complex(const PlaneMesh& mesh) {
  if (mesh.triangles.empty()) throw InvalidInput("the mesh has no triangles", mesh.name);
  check_points(mesh);
  std::vector<TriangleComplex::Nodes> triangles;
  triangles.reserve(mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    triangles.push_back(checked_triangle(mesh, t));
  }
  check_edges(mesh, triangles);
  return make_triangle_complex(mesh.points, std::move(triangles));
}

void check_values(const PlaneMesh& mesh, std::span<const double> values, const std::string& name) {
  if (values.size() != mesh.points.size()) {
    throw InvalidInput("gives values at " + std::to_string(values.size()) +
                           " nodes; the mesh has " + std::to_string(mesh.points.size()),
                       name);
  }
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (std::abs(values[i]) < 1e100) continue;
    std::array<char, 60> text{};
    std::snprintf(text.data(), text.size(), "the value %.6g is no usable number", values[i]);
    throw InvalidInput(text.data(), in_file(name, "node " + std::to_string(i + 1) + " at " +
                                                      place_text(mesh.points[i])));
  }
}

void check_metrics(const PlaneMesh& mesh, std::span<const Metric2> metrics,
                   const std::string& name) {
  if (metrics.size() != mesh.points.size()) {
    throw InvalidInput("there are " + std::to_string(metrics.size()) + " metrics for " +
                           std::to_string(mesh.points.size()) + " nodes",
                       name);
  }
  for (std::size_t i = 0; i < metrics.size(); ++i) {
    const Metric2& m = metrics[i];
    if (is_metric(m) && m.xx < 1e100 && m.yy < 1e100 && determinant(m) > 1e-200) continue;
    std::array<char, 160> text{};
    std::snprintf(text.data(), text.size(),
                  "the metric [%.6g %.6g; %.6g %.6g] is not positive definite", m.xx, m.xy, m.xy,
                  m.yy);
    throw InvalidInput(text.data(), in_file(name, "node " + std::to_string(i + 1) + " at " +
                                                      place_text(mesh.points[i])));
  }
}

MetricMesh make_metric_mesh(const PlaneMesh& mesh, const TriangleComplex& complex,
                            std::span<const Metric2> metrics, double corner_angle_deg,
                            std::span<const PatchCurve> curves) {
  TF_CHECK(metrics.size() == mesh.points.size() && mesh.patches.size() == mesh.edges.size());
  TF_CHECK(mesh.triangles.empty() || complex.triangles.size() == mesh.triangles.size());
  const std::size_t triangles = complex.triangles.size();
  TF_CHECK(mesh.regions.empty() || mesh.regions.size() == triangles);
  MetricMesh out;
  out.complex = complex;
  out.regions.assign(triangles, 0);
  std::copy(mesh.regions.begin(), mesh.regions.end(), out.regions.begin());
  out.metrics.assign(metrics.begin(), metrics.end());
  out.homes = complex.node2triangle;
  out.curve_of_node.assign(mesh.points.size(), MetricMesh::inside);
  out.parameters.assign(mesh.points.size(), 0);
  out.active.assign(mesh.points.size(), 0);
  out.touched.assign(mesh.points.size(), 0);
  out.energies.assign(triangles, MetricMesh::unknown_energy);
  out.unchecked.assign(triangles, 0);
  const std::vector<HeldEdge> held = hold_edges(mesh, out.complex);
  const TracedBoundary traced = trace_boundary(mesh, held, corner_angle_deg);
  for (const BoundaryPiece& piece : traced.pieces) add_curve(out, piece, curves);
  for (const std::int32_t v : traced.corners) out.curve_of_node[at(v)] = MetricMesh::corner;
  return out;
}

MeshWithMetrics plane_mesh_of(const MetricMesh& mesh) {
  MeshWithMetrics out;
  std::vector<std::int32_t> numbers(mesh.complex.points.size(), -1);
  const auto number_of = [&](std::int32_t node) {
    std::int32_t& number = numbers[at(node)];
    if (number < 0) {
      number = static_cast<std::int32_t>(out.mesh.points.size());
      out.mesh.points.push_back(mesh.complex.point(node));
      out.metrics.push_back(mesh.metrics[at(node)]);
      if (mesh.curve_of_node[at(node)] == MetricMesh::corner) out.mesh.corners.push_back(number);
    }
    return number;
  };
  const std::vector<std::int32_t> order = triangles_in_order(mesh);
  out.mesh.triangles.reserve(order.size());
  out.mesh.regions.reserve(order.size());
  for (const std::int32_t t : order) {
    const TriangleComplex::Nodes& n = mesh.complex.nodes(t);
    const std::int32_t a = number_of(n[0]);
    const std::int32_t b = number_of(n[1]);
    const std::int32_t c = number_of(n[2]);
    out.mesh.triangles.push_back({a, b, c});
    out.mesh.regions.push_back(mesh.regions[at(t)]);
    for (int i = 0; i < 3; ++i) {
      if (!mesh.complex.is_constrained(t, i)) continue;
      const std::int32_t from = n[at(next(i))];
      const std::int32_t to = n[at(previous(i))];
      if (mesh.complex.neighbour(t, i) != no_edge && from > to) continue;
      out.mesh.edges.push_back({number_of(from), number_of(to)});
      out.mesh.patches.push_back(mesh.curves[at(curve_of_edge(mesh, from, to))].patch);
    }
  }
  return out;
}

}  // namespace tetfarm
