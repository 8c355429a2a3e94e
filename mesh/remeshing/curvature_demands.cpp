#include "mesh/remeshing/curvature_demands.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>

#include "mesh/geometry/triangle_intersection.h"
#include "mesh/inspect/surface_edges.h"
#include "mesh/remeshing/local_tolerance.h"
#include "mesh/remeshing/triangle_normal.h"

namespace tetfarm {
namespace {

/// Of the radius: 18 edges to a circle.
constexpr double longest_of_radius = 0.35;
/// A normal of a triangle lower than that share of its longest edge says nothing.
constexpr double sure_height_share = 1e-4;
constexpr double most_along_an_edge = 1000;

const Vec3& vertex_at(const SurfaceMesh& surface, std::int32_t v) {
  return surface.vertices[static_cast<std::size_t>(v)];
}

double wanted_on_radius(double radius, double tolerance, const RemeshOptions& options) {
  const double wanted = std::min(std::sqrt(8 * radius * tolerance), longest_of_radius * radius);
  return std::max(wanted, options.min_size);
}

struct BentTriangle {
  Vec3 normal;
  double height = 0;  ///< over the edge looked at
};

std::optional<BentTriangle> over_edge(const SurfaceMesh& surface, const EdgeUse& use) {
  const TrianglePoints c =
      triangle_points(surface.vertices, surface.triangles[static_cast<std::size_t>(use.triangle)]);
  const Vec3 normal = sure_normal(c, sure_height_share);
  if (norm2(normal) == 0) return std::nullopt;
  const double length = distance(vertex_at(surface, use.low), vertex_at(surface, use.high));
  return BentTriangle{normal, norm(doubled_area(c)) / length};
}

/// The spacing wanted across an edge inside a face; as large as one likes where it is flat.
double wanted_over_edge(const SurfaceMesh& surface, std::span<const EdgeUse> edge, double tolerance,
                        const RemeshOptions& options) {
  const std::optional<BentTriangle> a = over_edge(surface, edge[0]);
  const std::optional<BentTriangle> b = over_edge(surface, edge[1]);
  if (!a || !b) return HUGE_VAL;
  // Twice the sine of half the angle, for the angle.
  const double angle = norm(a->normal - b->normal);
  if (angle == 0) return HUGE_VAL;
  return wanted_on_radius(std::min(a->height, b->height) / angle, tolerance, options);
}

void add_along(const Vec3& from, const Vec3& to, double wanted, std::vector<PointDemand>& demands) {
  const double length = distance(from, to);
  const double most = demands.size() < most_curvature_demands ? most_along_an_edge : 1;
  const int parts = static_cast<int>(std::clamp(std::ceil(length / (2 * wanted)), 1.0, most));
  for (int i = 0; i < parts; ++i) {
    const double share = (i + 0.5) / parts;
    demands.push_back({from + share * (to - from), wanted, wanted});
  }
}

/// At a vertex between two edges of a curve.
double wanted_on_curve(const SurfaceMesh& surface, std::size_t v,
                       const std::array<std::int32_t, 2>& ends, double tolerance,
                       const RemeshOptions& options) {
  const Vec3 in = surface.vertices[v] - vertex_at(surface, ends[0]);
  const Vec3 out = vertex_at(surface, ends[1]) - surface.vertices[v];
  const double angle = norm(normalized(in) - normalized(out));
  if (angle == 0) return HUGE_VAL;
  return wanted_on_radius(std::min(norm(in), norm(out)) / angle, tolerance, options);
}

void add_curves(const SurfaceMesh& surface, const SurfaceFeatures& features,
                const std::vector<double>& shares, const RemeshOptions& options,
                std::vector<PointDemand>& demands) {
  // Of the face that has most.
  std::vector<double> share_at(surface.vertices.size(), 0);
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    for (const std::int32_t v : surface.triangles[t]) {
      double& share = share_at[static_cast<std::size_t>(v)];
      share = std::max(share, shares[t]);
    }
  }
  std::vector<std::array<std::int32_t, 2>> ends(surface.vertices.size(), {-1, -1});
  for (const std::array<std::int32_t, 2>& edge : features.edges) {
    for (std::size_t k = 0; k < 2; ++k) {
      std::array<std::int32_t, 2>& of = ends[static_cast<std::size_t>(edge[k])];
      of[of[0] < 0 ? 0 : 1] = edge[1 - k];
    }
  }
  for (std::size_t v = 0; v < surface.vertices.size(); ++v) {
    if (features.kind[v] != VertexKind::on_curve) continue;
    const double wanted =
        wanted_on_curve(surface, v, ends[v], share_at[v] * options.tolerance, options);
    if (wanted < options.size) demands.push_back({surface.vertices[v], wanted, wanted});
  }
}

}  // namespace

std::vector<PointDemand> curvature_demands(const SurfaceMesh& surface,
                                           const SurfaceFeatures& features,
                                           const RemeshOptions& options) {
  const std::vector<EdgeUse> uses = edge_uses(surface.triangles);
  std::vector<PointDemand> demands;
  const std::vector<double> shares = shares_of_tolerance(surface, features, options);
  add_curves(surface, features, shares, options, demands);
  for_each_edge(uses, [&](std::span<const EdgeUse> edge) {
    if (edge.size() != 2) return;
    const std::array<std::int32_t, 2> ends{edge[0].low, edge[0].high};
    if (std::ranges::binary_search(features.edges, ends)) return;
    const double tolerance = shares[static_cast<std::size_t>(edge[0].triangle)] * options.tolerance;
    const double wanted = wanted_over_edge(surface, edge, tolerance, options);
    if (wanted < options.size) {
      add_along(vertex_at(surface, ends[0]), vertex_at(surface, ends[1]), wanted, demands);
    }
  });
  return demands;
}

}  // namespace tetfarm
