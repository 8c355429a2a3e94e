#include "mesh/remeshing/remesh.h"

#include <algorithm>
#include <utility>

#include "base/check.h"
#include "mesh/geometry/box_tree.h"
#include "mesh/geometry/triangle_distance.h"
#include "mesh/geometry/triangle_intersection.h"
#include "mesh/inspect/self_intersection.h"
#include "mesh/remeshing/angle_smoothing.h"
#include "mesh/remeshing/box_forest.h"
#include "mesh/remeshing/changing_surface.h"
#include "mesh/remeshing/edge_collapse.h"
#include "mesh/remeshing/edge_flip.h"
#include "mesh/remeshing/edge_length.h"
#include "mesh/remeshing/edge_split.h"
#include "mesh/remeshing/input_shape.h"
#include "mesh/remeshing/local_tolerance.h"
#include "mesh/remeshing/straying_triangles.h"
#include "mesh/remeshing/surface_to_remesh.h"
#include "mesh/remeshing/tangential_smoothing.h"

namespace tetfarm {
namespace {

/// Edges longer than this many spacings are split, shorter ones drawn together, so that they come
/// to 1 on average: Botsch and Kobbelt's 4/3 and 4/5 come to 0.91.
constexpr double longest_edge = 1.45;
constexpr double shortest_edge = 0.87;
/// Worse triangles may be made only of worse ones yet.
constexpr double good_shape = 0.6;
/// Triangles of a lesser shape are divided across their longest edge or not at all.
constexpr double flat_shape = 0.05;
/// Of the tolerance: between the points that are compared a triangle may lie farther off.
constexpr double tolerance_at_samples = 0.5;
/// How often vertices of the input that were left behind are kept, and all is done again.
constexpr int most_rounds = 4;
constexpr int most_splitting_sweeps = 100;
/// More turns change much and better nothing.
constexpr int turns = 4;
/// At the end, the smallest angles are raised above 35 degrees where that can be.
constexpr double cosine_wanted = 0.8192;
constexpr int most_hunts = 10;

bool collapse_either_way(RemeshingWork& work, const MeasuredEdge& edge) {
  const auto [a, b] = edge.ends;
  // First the one that has more freedom to go.
  const bool is_a_first = work.surface.vertex(a).kind <= work.surface.vertex(b).kind;
  const std::int32_t first = is_a_first ? a : b;
  const std::int32_t second = is_a_first ? b : a;
  return collapse_edge(work, first, second, longest_edge, good_shape) ||
         collapse_edge(work, second, first, longest_edge, good_shape);
}

std::int64_t collapse_short_edges(RemeshingWork& work) {
  std::int64_t count = 0;
  for (const MeasuredEdge& edge : edges_shorter_than(work, shortest_edge)) {
    const auto [a, b] = edge.ends;
    // What came meanwhile may be longer.
    if (work.surface.ring(a).empty() || work.surface.ring(b).empty()) continue;
    if (edge_length(work, a, b) < shortest_edge && collapse_either_way(work, edge)) ++count;
  }
  return count;
}

/// A flat triangle is divided across its longest edge first: divided across another it would leave
/// a flatter one on that edge, and so on until there is nothing between them but rounding.
bool waits_for_longer_edge(const RemeshingWork& work, std::int32_t a, std::int32_t b) {
  const ChangingSurface& surface = work.surface;
  const double length2 = norm2(surface.at(b) - surface.at(a));
  const auto is_longer = [&](std::int32_t p, std::int32_t q) {
    return norm2(surface.at(q) - surface.at(p)) > length2 && edge_length(work, p, q) > longest_edge;
  };
  return std::ranges::any_of(surface.triangles_on(a, b), [&](std::int32_t t) {
    const Triangle& nodes = surface.triangle(t).nodes;
    return triangle_shape(surface.points(nodes)) < flat_shape &&
           (is_longer(nodes[0], nodes[1]) || is_longer(nodes[1], nodes[2]) ||
            is_longer(nodes[2], nodes[0]));
  });
}

std::int64_t split_long_edges(RemeshingWork& work) {
  std::int64_t count = 0;
  const std::vector<MeasuredEdge> edges = edges_longer_than(work, longest_edge, work.split);
  work.split = work.surface.now();
  for (const MeasuredEdge& edge : edges) {
    const auto [a, b] = edge.ends;
    // After flips, those beside an edge that was split may not be there any more, or be shorter.
    if (work.surface.has_new_triangle(work.split, a, b)) continue;
    if (waits_for_longer_edge(work, a, b)) continue;
    if (split_edge(work, a, b)) ++count;
  }
  return count;
}

void split_until_short(RemeshingWork& work) {
  for (int sweep = 0; sweep < most_splitting_sweeps; ++sweep) {
    const std::int64_t splits = split_long_edges(work);
    flip_edges(work, FlipFor::shape);
    if (splits == 0) return;
  }
}

RemeshedSurface result_of(const ChangingSurface& changed, const SurfaceMesh& input,
                          const SurfaceFeatures& features) {
  RemeshedSurface result;
  SurfaceMesh& surface = result.surface;
  surface.patch_names = input.patch_names;
  surface.region_names = input.region_names;
  std::vector<std::size_t> triangle_of_face(static_cast<std::size_t>(features.face_count));
  for (std::size_t t = input.triangles.size(); t-- > 0;) {
    triangle_of_face[static_cast<std::size_t>(features.face[t])] = t;
  }
  std::vector<std::int32_t> number(static_cast<std::size_t>(changed.vertex_end()), -1);
  for (std::int32_t v = 0; v < changed.vertex_end(); ++v) {
    if (changed.ring(v).empty()) continue;
    number[static_cast<std::size_t>(v)] = static_cast<std::int32_t>(surface.vertices.size());
    surface.vertices.push_back(changed.at(v));
  }
  for (std::int32_t t = 0; t < changed.triangle_end(); ++t) {
    if (!changed.is_there(t)) continue;
    const FaceTriangle& of = changed.triangle(t);
    Triangle nodes{};
    for (std::size_t k = 0; k < 3; ++k) nodes[k] = number[static_cast<std::size_t>(of.nodes[k])];
    surface.triangles.push_back(nodes);
    const std::size_t from = triangle_of_face[static_cast<std::size_t>(of.face)];
    if (!input.patch_of_triangle.empty()) {
      surface.patch_of_triangle.push_back(input.patch_of_triangle[from]);
    }
    if (!input.sides.empty()) surface.sides.push_back(input.sides[from]);
    for (std::size_t k = 0; k < 3; ++k) {
      if (!is_feature_side(of, k)) continue;
      const std::int32_t a = nodes[k];
      const std::int32_t b = nodes[(k + 1) % 3];
      result.feature_edges.push_back({std::min(a, b), std::max(a, b)});
    }
  }
  std::ranges::sort(result.feature_edges);
  result.feature_edges.erase(std::unique(result.feature_edges.begin(), result.feature_edges.end()),
                             result.feature_edges.end());
  return result;
}

void number_by_place(RemeshingWork& work) {
  work.surface.number_by_place();
  work.flipped = 0;
  work.split = 0;
}

void remesh_in_turns(RemeshingWork& work) {
  flip_edges(work, FlipFor::shape);
  for (int turn = 0; turn < turns; ++turn) {
    while (collapse_short_edges(work) > work.surface.triangle_count() / 100) {
    }
    flip_edges(work, FlipFor::shape);
    split_until_short(work);
    if (turn + 1 < turns) flip_edges(work, FlipFor::valence);
    smooth_vertices(work, good_shape);
    flip_edges(work, FlipFor::shape);
    smooth_vertices(work, good_shape);
    measure_spacings(work);
    if (turn == 0) number_by_place(work);
  }
  for (int hunt = 0; hunt < most_hunts; ++hunt) {
    if (raise_angles(work, cosine_wanted) == 0) break;
    flip_edges(work, FlipFor::shape);
  }
}

RemeshedSurface remeshed(const SurfaceMesh& surface, const SurfaceFeatures& features,
                         const InputShape& shape, const RemeshingSpacing& spacing,
                         const RemeshOptions& options, bool is_strict) {
  ChangingSurface changed = surface_to_remesh(surface, features, shape, spacing);
  RemeshingWork work{changed, shape, spacing, tolerance_at_samples * options.tolerance, is_strict};
  remesh_in_turns(work);
  split_straying_triangles(work, options.tolerance);
  return result_of(changed, surface, features);
}

bool has_crossings(const SurfaceMesh& surface) {
  const std::vector<char> all(surface.triangles.size(), 1);
  return check_self_intersection(surface, all).has_value();
}

/// Near as each change is to the input, many may carry the surface away from one of its vertices.
/// Those farther than the tolerance become corners. The number of them.
std::int64_t keep_vertices_left_behind(const SurfaceMesh& surface, const SurfaceMesh& result,
                                       const std::vector<double>& tolerance,
                                       SurfaceFeatures& features) {
  const BoxForest forest(triangle_boxes(result.vertices, result.triangles),
                         std::vector<std::int32_t>(result.triangles.size(), 0), 1);
  std::int64_t count = 0;
  for (std::size_t v = 0; v < surface.vertices.size(); ++v) {
    const Vec3& p = surface.vertices[v];
    const BoxForest::Nearest found =
        forest.nearest(0, p, tolerance[v] * tolerance[v], [&](std::int32_t t) {
          const TrianglePoints c =
              triangle_points(result.vertices, result.triangles[static_cast<std::size_t>(t)]);
          return distance2_to_triangle(p, c[0], c[1], c[2]);
        });
    if (found.item >= 0 || features.kind[v] == VertexKind::corner) continue;
    features.kind[v] = VertexKind::corner;
    ++count;
  }
  return count;
}

/// Of each vertex: that of the triangle round it where it is largest.
std::vector<double> tolerances_at_vertices(const SurfaceMesh& surface,
                                           const SurfaceFeatures& features,
                                           const RemeshOptions& options) {
  const std::vector<double> shares = shares_of_tolerance(surface, features, options);
  std::vector<double> at_vertices(surface.vertices.size(), 0);
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    for (const std::int32_t v : surface.triangles[t]) {
      double& here = at_vertices[static_cast<std::size_t>(v)];
      here = std::max(here, shares[t] * options.tolerance);
    }
  }
  return at_vertices;
}

RemeshedSurface sound_surface(const SurfaceMesh& surface, const SurfaceFeatures& features,
                              const RemeshingSpacing& spacing, const RemeshOptions& options) {
  const InputShape shape(surface, features, shares_of_tolerance(surface, features, options));
  RemeshedSurface result = remeshed(surface, features, shape, spacing, options, false);
  if (has_crossings(result.surface)) {
    result = remeshed(surface, features, shape, spacing, options, true);
    TF_CHECK(!has_crossings(result.surface));
  }
  return result;
}

}  // namespace

RemeshedSurface remesh(const SurfaceMesh& surface, const SurfaceFeatures& features,
                       const RemeshingSpacing& spacing, const RemeshOptions& options) {
  SurfaceFeatures kept = features;
  const std::vector<double> tolerances = tolerances_at_vertices(surface, features, options);
  RemeshedSurface result = sound_surface(surface, kept, spacing, options);
  for (int round = 0; round < most_rounds; ++round) {
    if (keep_vertices_left_behind(surface, result.surface, tolerances, kept) == 0) break;
    result = sound_surface(surface, kept, spacing, options);
  }
  return result;
}

}  // namespace tetfarm
