#include "mesh/adaptation/loop_domain.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/array_index.h"
#include "base/check.h"
#include "base/error.h"
#include "mesh/adaptation/ellipse_cavity.h"
#include "mesh/adaptation/metric_mesh.h"
#include "mesh/planar/constrained_delaunay.h"

namespace tetfarm {
namespace {

constexpr double largest_ratio = 1.5;  ///< of the sizes at the two ends of an edge

double signed_area(const std::vector<Vec2>& points) {
  double doubled = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec2& a = points[i];
    const Vec2& b = points[(i + 1) % points.size()];
    doubled +=
        (a.x - points[0].x) * (b.y - points[0].y) - (b.x - points[0].x) * (a.y - points[0].y);
  }
  return doubled / 2;
}

/// Crossings of the ray from p to the right with the loop are odd.
bool encloses(const std::vector<Vec2>& loop, const Vec2& p) {
  bool is_inside = false;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Vec2& a = loop[i];
    const Vec2& b = loop[(i + 1) % loop.size()];
    if ((a.y > p.y) == (b.y > p.y)) continue;
    const double side = orient2d(a, b, p);
    if ((b.y > a.y) == (side > 0)) is_inside = !is_inside;
  }
  return is_inside;
}

/// The domain lies to the left of the loop in its own direction.
bool runs_right(const std::vector<DomainLoop>& loops, std::size_t loop) {
  int depth = 0;
  for (std::size_t other = 0; other < loops.size(); ++other) {
    if (other == loop) continue;
    depth += encloses(loops[other].points, loops[loop].points.front()) ? 1 : 0;
  }
  return (signed_area(loops[loop].points) > 0) == (depth % 2 == 0);
}

[[noreturn]] void refuse(const PlanarFailure& failure, const std::string& name) {
  std::string what = failure.reason;
  const std::size_t told = std::min<std::size_t>(failure.where.size(), 5);
  for (std::size_t i = 0; i < told; ++i) {
    what += (i == 0 ? ", at " : ", ") + place_text(failure.where[i]);
  }
  if (told < failure.where.size()) {
    what += " and " + std::to_string(failure.where.size() - told) + " more places";
  }
  throw InvalidInput(what, name);
}

/// At each point of the mesh the metric of the mean length of its boundary edges.
std::vector<Metric2> boundary_metrics(const PlaneMesh& mesh) {
  std::vector<double> sums(mesh.points.size(), 0);
  std::vector<double> counts(mesh.points.size(), 0);
  for (const auto& [a, b] : mesh.edges) {
    const Vec2& p = mesh.points[at(a)];
    const Vec2& q = mesh.points[at(b)];
    for (const std::int32_t v : {a, b}) {
      sums[at(v)] += std::hypot(q.x - p.x, q.y - p.y);
      counts[at(v)] += 1;
    }
  }
  std::vector<Metric2> metrics;
  for (std::size_t v = 0; v < sums.size(); ++v) {
    const double size = counts[v] > 0 ? sums[v] / counts[v] : 1;
    metrics.push_back(metric_of_sizes({size, size, 0}));
  }
  return metrics;
}

/// Puts a node on an inner edge whose ends differ in size, where the size is the geometric mean.
bool divide_by_size(MetricMesh& mesh, EllipseCavity& cavity, EdgeHandle edge) {
  const std::int32_t t = triangle_of(edge);
  const int i = edge_of(edge);
  if (mesh.complex.is_constrained(t, i)) return false;
  const std::int32_t a = mesh.complex.node(t, next(i));
  const std::int32_t b = mesh.complex.node(t, previous(i));
  const double of_a = 1 / std::sqrt(mesh.metrics[at(a)].xx);
  const double of_b = 1 / std::sqrt(mesh.metrics[at(b)].xx);
  if (std::max(of_a, of_b) < largest_ratio * std::min(of_a, of_b)) return false;
  const double size = std::sqrt(of_a * of_b);
  const double share = (size - of_a) / (of_b - of_a);
  const Vec2& p = mesh.complex.point(a);
  const Vec2& q = mesh.complex.point(b);
  NodePlace place;
  place.point = {p.x + share * (q.x - p.x), p.y + share * (q.y - p.y)};
  place.metric = metric_of_sizes({size, size, 0});
  if (!cavity.find(mesh, place, edge)) return false;
  cavity.fill(mesh, add_node(mesh, place));
  return true;
}

}  // namespace

PlaneMesh domain_of_loops(const std::vector<DomainLoop>& loops) {
  TF_CHECK(!loops.empty());
  PlaneMesh mesh;
  PlanarRegion region;
  for (std::size_t k = 0; k < loops.size(); ++k) {
    const auto first = static_cast<std::int32_t>(region.points.size());
    const auto count = static_cast<std::int32_t>(loops[k].points.size());
    region.points.insert(region.points.end(), loops[k].points.begin(), loops[k].points.end());
    const bool is_right = runs_right(loops, k);
    if (!loops[k].patch_name.empty()) mesh.patch_names[loops[k].patch] = loops[k].patch_name;
    for (std::int32_t i = 0; i < count; ++i) {
      const std::int32_t a = first + i;
      const std::int32_t b = first + (i + 1) % count;
      region.edges.push_back(is_right ? std::array{a, b} : std::array{b, a});
      mesh.patches.push_back(loops[k].patch);
    }
  }
  const ConstrainedDelaunay delaunay = constrained_delaunay(region);
  if (delaunay.failure.has_value()) refuse(*delaunay.failure, loops.front().name);
  mesh.points = region.points;
  mesh.edges = region.edges;
  mesh.triangles = delaunay.complex.triangles;
  mesh.regions.assign(mesh.triangles.size(), 1);
  return mesh;
}

MeshWithMetrics sized_by_boundary(const PlaneMesh& domain) {
  TriangleComplex complex = checked_complex(domain);
  MetricMesh mesh = make_metric_mesh(domain, complex, boundary_metrics(domain), 180);
  EllipseCavity cavity({EllipseTest::at_new_node, 0});
  bool is_done = false;
  while (!is_done) {
    is_done = true;
    const std::int32_t triangles = mesh.complex.size();
    for (std::int32_t t = 0; t < triangles; ++t) {
      for (int i = 0; i < 3; ++i) {
        if (divide_by_size(mesh, cavity, edge_handle(t, i))) is_done = false;
      }
    }
  }
  MeshWithMetrics sized = plane_mesh_of(mesh);
  sized.mesh.patch_names = domain.patch_names;
  return sized;
}

}  // namespace tetfarm
