#include "mesh/remeshing/proximity_demands.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <span>
#include <utility>

#include "mesh/geometry/box_tree.h"
#include "mesh/geometry/nearest_point.h"
#include "mesh/geometry/triangle_intersection.h"
#include "mesh/inspect/surface_edges.h"
#include "mesh/remeshing/box_forest.h"
#include "mesh/remeshing/triangle_normal.h"
#include "mesh/remeshing/triangle_samples.h"

namespace tetfarm {
namespace {

constexpr double edges_across = 3;
/// Triangles do not become as small as every edge between corners, but no larger than this share of
/// min_size there: towards an edge of nothing there would be no end of them.
constexpr double least_of_min_size = 1.0 / 16;
/// Cosine of the angle between normals, 8 degrees, up to which two walls are parallel.
constexpr double facing_cosine = 0.99;
/// Cosine of the angle with an edge above which the way from it is not across.
constexpr double across_cosine = 0.3;
/// Of the largest side of the box: nearer is the triangle itself.
constexpr double least_distance_share = 1e-9;

struct RaySearch {
  const SurfaceMesh& surface;
  const BoxTree& tree;
  std::vector<Vec3> normals;
  double reach = 0;
  double nearest = 0;
};

double on_ray(const Vec3& from, const Vec3& direction, const TrianglePoints& t) {
  const Vec3 u = t[1] - t[0];
  const Vec3 v = t[2] - t[0];
  const Vec3 p = cross(direction, v);
  const double volume = dot(u, p);
  if (volume == 0) return HUGE_VAL;
  const Vec3 away = from - t[0];
  const double a = dot(away, p) / volume;
  const Vec3 q = cross(away, u);
  const double b = dot(direction, q) / volume;
  if (a < 0 || b < 0 || a + b > 1) return HUGE_VAL;
  return dot(v, q) / volume;
}

/// The distance to the nearest triangle along the direction that faces the one with this normal.
double facing_distance(const RaySearch& search, const Vec3& from, const Vec3& normal, double side) {
  const Vec3 direction = side * normal;
  Box3 box;
  box.add(from);
  box.add(from + search.reach * direction);
  double found = HUGE_VAL;
  search.tree.query(box, [&](std::int32_t t) {
    if (dot(search.normals[static_cast<std::size_t>(t)], normal) > -facing_cosine) return;
    const double at =
        on_ray(from, direction,
               triangle_points(search.surface.vertices,
                               search.surface.triangles[static_cast<std::size_t>(t)]));
    if (at > search.nearest && at < found) found = at;
  });
  return found;
}

/// The least distance found.
double add_walls(const RaySearch& search, const Vec3& from, const Vec3& normal,
                 const RemeshOptions& options, std::vector<PointDemand>& demands) {
  double least = HUGE_VAL;
  for (const double side : {-1.0, 1.0}) {
    const double across = facing_distance(search, from, normal, side);
    const double wanted = std::max(across / edges_across, options.min_size);
    if (!(wanted < options.size)) continue;
    least = std::min(least, across);
    demands.push_back({from, wanted, across});
    demands.push_back({from + across * side * normal, wanted, across});
  }
  return least;
}

void add_thin_parts(const SurfaceMesh& surface, const RemeshOptions& options,
                    std::vector<PointDemand>& demands) {
  const Vec3 size = bounding_box(surface.vertices).size();
  const BoxTree tree(triangle_boxes(surface.vertices, surface.triangles));
  RaySearch search{surface,
                   tree,
                   {},
                   edges_across * options.size,
                   least_distance_share * std::max({size.x, size.y, size.z})};
  for (const Triangle& t : surface.triangles) {
    const TrianglePoints c = triangle_points(surface.vertices, t);
    search.normals.push_back(normalized(doubled_area(c)));
  }
  const double step = std::max(options.size, sample_step(surface, most_proximity_samples));
  double samples_left = most_proximity_samples;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const TrianglePoints c = triangle_points(surface.vertices, surface.triangles[t]);
    double least = HUGE_VAL;
    const auto look = [&](const Vec3& p) {
      least = std::min(least, add_walls(search, p, search.normals[t], options, demands));
    };
    sample_triangle(c, step, look);
    // A demand reaches as far as the walls are from each other: nearer samples where they are near.
    const double finer = std::max(least, options.min_size);
    const double samples = 0.5 * norm(doubled_area(c)) / (finer * finer);
    if (finer >= step || samples > samples_left) continue;
    samples_left -= samples;
    sample_triangle(c, finer, look);
  }
}

/// A feature edge as a border of one face.
struct Border {
  Vec3 from;
  Vec3 to;
  std::array<std::int32_t, 2> ends;
};

struct Borders {
  std::vector<Border> edges;
  std::vector<std::int32_t> face;
  double length = 0;
};

Borders borders_of(const SurfaceMesh& surface, const SurfaceFeatures& features) {
  Borders borders;
  const std::vector<EdgeUse> uses = edge_uses(surface.triangles);
  for_each_edge(uses, [&](std::span<const EdgeUse> edge) {
    const std::array<std::int32_t, 2> ends{edge[0].low, edge[0].high};
    if (!std::ranges::binary_search(features.edges, ends)) return;
    for (const EdgeUse& use : edge) {
      borders.edges.push_back({surface.vertices[static_cast<std::size_t>(ends[0])],
                               surface.vertices[static_cast<std::size_t>(ends[1])], ends});
      borders.face.push_back(features.face[static_cast<std::size_t>(use.triangle)]);
      borders.length += distance(borders.edges.back().from, borders.edges.back().to);
    }
  });
  return borders;
}

/// The distance across the face to a border nearly parallel; infinite where there is none.
double across_strip(const Borders& borders, const BoxForest& forest, std::size_t own,
                    const Vec3& from, double reach) {
  const Border& here = borders.edges[own];
  const Vec3 along = normalized(here.to - here.from);
  const auto distance2 = [&](std::int32_t e) {
    const Border& other = borders.edges[static_cast<std::size_t>(e)];
    for (const std::int32_t end : other.ends) {
      if (end == here.ends[0] || end == here.ends[1]) return HUGE_VAL;
    }
    const Vec3 way = nearest_on_segment(from, other.from, other.to) - from;
    const double length = norm(way);
    const Vec3 other_along = normalized(other.to - other.from);
    if (std::abs(dot(way, along)) > across_cosine * length ||
        std::abs(dot(way, other_along)) > across_cosine * length) {
      return HUGE_VAL;
    }
    return length * length;
  };
  const BoxForest::Nearest found =
      forest.nearest(borders.face[own], from, reach * reach, distance2);
  return found.item < 0 ? HUGE_VAL : std::sqrt(found.distance2);
}

void add_strips(const SurfaceMesh& surface, const SurfaceFeatures& features,
                const RemeshOptions& options, std::vector<PointDemand>& demands) {
  const Borders borders = borders_of(surface, features);
  std::vector<Box3> boxes;
  for (const Border& border : borders.edges) {
    Box3& box = boxes.emplace_back();
    box.add(border.from);
    box.add(border.to);
  }
  const BoxForest forest(boxes, borders.face, features.face_count);
  const double step = std::max(2 * options.min_size, borders.length / most_proximity_samples);
  for (std::size_t e = 0; e < borders.edges.size(); ++e) {
    const Border& border = borders.edges[e];
    const double length = distance(border.from, border.to);
    const int parts = std::max(1, static_cast<int>(std::min(length / step, 1e5)));
    for (int i = 0; i < parts; ++i) {
      const Vec3 from = border.from + (i + 0.5) / parts * (border.to - border.from);
      const double across = across_strip(borders, forest, e, from, options.size);
      const double wanted = std::max(across, options.min_size);
      if (wanted < options.size) demands.push_back({from, wanted, wanted});
    }
  }
}

/// Both ends of such an edge stay, and so does it.
void add_edges_between_corners(const SurfaceMesh& surface, const SurfaceFeatures& features,
                               const RemeshOptions& options, std::vector<PointDemand>& demands) {
  for (const std::array<std::int32_t, 2>& edge : features.edges) {
    const auto a = static_cast<std::size_t>(edge[0]);
    const auto b = static_cast<std::size_t>(edge[1]);
    if (features.kind[a] != VertexKind::corner || features.kind[b] != VertexKind::corner) continue;
    const double length = distance(surface.vertices[a], surface.vertices[b]);
    if (length >= options.size) continue;
    const double wanted = std::max(length, least_of_min_size * options.min_size);
    demands.push_back({0.5 * (surface.vertices[a] + surface.vertices[b]), wanted, length});
  }
}

}  // namespace

std::vector<PointDemand> proximity_demands(const SurfaceMesh& surface,
                                           const SurfaceFeatures& features,
                                           const RemeshOptions& options) {
  std::vector<PointDemand> demands;
  add_thin_parts(surface, options, demands);
  add_strips(surface, features, options, demands);
  add_edges_between_corners(surface, features, options, demands);
  return demands;
}

}  // namespace tetfarm
