#include "mesh/remeshing/remeshing_figures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "mesh/core/triangle_angles.h"
#include "mesh/geometry/box_tree.h"
#include "mesh/geometry/triangle_distance.h"
#include "mesh/geometry/triangle_intersection.h"
#include "mesh/remeshing/box_forest.h"
#include "mesh/remeshing/triangle_normal.h"
#include "mesh/remeshing/triangle_samples.h"

namespace tetfarm {
namespace {

constexpr double most_points = 2e6;
/// On average: more of them tell hardly more.
constexpr double points_of_triangle = 20;
constexpr double shortest_fit = 0.6;
constexpr double longest_fit = 1.5;

double radius_ratio(const TrianglePoints& c) {
  const double x = distance(c[0], c[1]);
  const double y = distance(c[1], c[2]);
  const double z = distance(c[2], c[0]);
  const double doubled = norm(doubled_area(c));
  return 4 * doubled * doubled / (x * y * z * (x + y + z));
}

/// The farthest of the points of `of` from `other`.
FarthestPoint farthest(const SurfaceMesh& of, const SurfaceMesh& other) {
  const BoxForest forest(triangle_boxes(other.vertices, other.triangles),
                         std::vector<std::int32_t>(other.triangles.size(), 0), 1);
  FarthestPoint found;
  double reach2 = norm2(bounding_box(other.vertices).size());
  std::int32_t last = 0;
  const auto look = [&](const Vec3& p) {
    const auto distance2 = [&](std::int32_t t) {
      const TrianglePoints c =
          triangle_points(other.vertices, other.triangles[static_cast<std::size_t>(t)]);
      return distance2_to_triangle(p, c[0], c[1], c[2]);
    };
    // What is near enough to one triangle need not be compared with the others.
    if (std::sqrt(distance2(last)) <= found.distance) return;
    const BoxForest::Nearest nearest = forest.nearest(0, p, 4 * reach2, distance2);
    if (nearest.item >= 0) last = nearest.item;
    const double distance = std::sqrt(nearest.distance2);
    if (distance > found.distance) found = {distance, p};
  };
  const double step = sample_step(
      of, std::min(most_points, points_of_triangle * static_cast<double>(of.triangles.size())));
  for (const Vec3& vertex : of.vertices) look(vertex);
  for (const Triangle& t : of.triangles)
    sample_triangle(triangle_points(of.vertices, t), step, look);
  return found;
}

std::vector<char> on_features(const RemeshedSurface& result) {
  std::vector<char> on(result.surface.vertices.size(), 0);
  for (const std::array<std::int32_t, 2>& edge : result.feature_edges) {
    for (const std::int32_t v : edge) on[static_cast<std::size_t>(v)] = 1;
  }
  return on;
}

void add_angles(const RemeshedSurface& result, RemeshingFigures& figures) {
  const std::vector<char> on = on_features(result);
  double ratios = 0;
  for (const Triangle& t : result.surface.triangles) {
    const TrianglePoints c = triangle_points(result.surface.vertices, t);
    const double angle = smallest_angle_deg(c[0], c[1], c[2]);
    ratios += radius_ratio(c);
    if (angle < figures.smallest_angle_deg) {
      figures.smallest_angle_deg = angle;
      figures.smallest_at = c[0];
    }
    if (angle < 20) ++figures.below_20_deg;
    if (angle < 30) ++figures.below_30_deg;
    const bool is_free = std::ranges::none_of(
        t, [&](std::int32_t v) { return on[static_cast<std::size_t>(v)] != 0; });
    if (!is_free) continue;
    ++figures.free_triangles;
    figures.smallest_free_angle_deg = std::min(figures.smallest_free_angle_deg, angle);
    if (angle < 30) ++figures.free_below_30_deg;
  }
  figures.mean_radius_ratio = ratios / static_cast<double>(figures.triangles);
}

/// Each edge once for each of its triangles.
void add_lengths(const SurfaceMesh& surface, const RemeshingSpacing& spacing,
                 RemeshingFigures& figures) {
  double sum = 0;
  double fit = 0;
  double edges = 0;
  for (const Triangle& t : surface.triangles) {
    const TrianglePoints c = triangle_points(surface.vertices, t);
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3& a = c[k];
      const Vec3& b = c[(k + 1) % 3];
      const double length = distance(a, b) / spacing.at(0.5 * (a + b));
      sum += length;
      edges += 1;
      if (length >= shortest_fit && length <= longest_fit) fit += 1;
    }
  }
  figures.mean_length = sum / edges;
  figures.well_sized = fit / edges;
}

}  // namespace

RemeshingFigures remeshing_figures(const SurfaceMesh& input, const RemeshedSurface& result,
                                   const RemeshingSpacing& spacing) {
  RemeshingFigures figures;
  figures.triangles_before = static_cast<std::int64_t>(input.triangles.size());
  figures.triangles = static_cast<std::int64_t>(result.surface.triangles.size());
  figures.vertices = static_cast<std::int64_t>(result.surface.vertices.size());
  for (const Triangle& t : input.triangles) {
    const TrianglePoints c = triangle_points(input.vertices, t);
    figures.smallest_angle_before_deg =
        std::min(figures.smallest_angle_before_deg, smallest_angle_deg(c[0], c[1], c[2]));
  }
  add_angles(result, figures);
  add_lengths(result.surface, spacing, figures);
  figures.from_input = farthest(result.surface, input);
  figures.to_input = farthest(input, result.surface);
  figures.volume_before = domain_volume(input);
  figures.volume = domain_volume(result.surface);
  return figures;
}

}  // namespace tetfarm
