#include "mesh/remeshing/edge_collapse.h"

#include <algorithm>
#include <vector>

#include "mesh/geometry/nearest_point.h"
#include "mesh/geometry/triangle_distance.h"
#include "mesh/remeshing/edge_length.h"

namespace tetfarm {
namespace {

using Vertices = std::vector<std::int32_t>;

/// The third vertices of the triangles on an edge, sorted.
Vertices opposite_vertices(const ChangingSurface& surface, const Vertices& on, std::int32_t a,
                           std::int32_t b) {
  Vertices opposite;
  for (const std::int32_t t : on) {
    opposite.push_back(third_vertex(surface.triangle(t).nodes, a, b));
  }
  std::ranges::sort(opposite);
  return opposite;
}

Vertices neighbours(const ChangingSurface& surface, std::int32_t v) {
  Vertices found;
  for (const std::int32_t t : surface.ring(v)) {
    for (const std::int32_t w : surface.triangle(t).nodes) {
      if (w != v) found.push_back(w);
    }
  }
  std::ranges::sort(found);
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

/// Whether the kinds of the two let `gone` be drawn into `kept`.
bool kinds_allow(const ChangingSurface& surface, const Vertices& on, std::int32_t gone,
                 std::int32_t kept) {
  const SurfaceVertex& from = surface.vertex(gone);
  if (from.kind == VertexKind::corner) return false;
  if (from.kind == VertexKind::smooth) return true;
  const SurfaceVertex& to = surface.vertex(kept);
  return surface.is_feature(on.front(), gone, kept) &&
         (to.kind == VertexKind::corner || to.home == from.home);
}

/// The link condition, and no two features drawn into one.
bool topology_allows(const ChangingSurface& surface, const Vertices& on, const Vertices& opposite,
                     std::int32_t gone, std::int32_t kept) {
  Vertices common;
  std::ranges::set_intersection(neighbours(surface, gone), neighbours(surface, kept),
                                std::back_inserter(common));
  if (common != opposite) return false;
  return std::ranges::none_of(on, [&](std::int32_t t) {
    return surface.is_feature(t, gone, third_vertex(surface.triangle(t).nodes, gone, kept));
  });
}

void make_ring(RemeshingWork& work, const Vertices& on, const Vertices& opposite, std::int32_t gone,
               std::int32_t kept) {
  const ChangingSurface& surface = work.surface;
  work.replacement.clear();
  work.replacement.removed.assign(surface.ring(gone).begin(), surface.ring(gone).end());
  work.replacement.fills_hole = surface.vertex(gone).kind == VertexKind::smooth;
  for (const std::int32_t t : work.replacement.removed) {
    if (std::ranges::find(on, t) != on.end()) continue;
    FaceTriangle made = surface.triangle(t);
    made.nodes[corner_of(made.nodes, gone)] = kept;
    for (const std::int32_t v : made.nodes) {
      if (v == kept || !std::ranges::binary_search(opposite, v)) continue;
      // The edge to v was that of a triangle that goes, which knows whether it is a feature.
      const auto beside = std::ranges::find_if(
          on, [&](std::int32_t s) { return has_corner(surface.triangle(s).nodes, v); });
      if (surface.is_feature(*beside, kept, v)) mark_feature_edge(made, kept, v);
    }
    work.replacement.made.push_back(made);
  }
}

bool lengths_allow(const RemeshingWork& work, std::int32_t gone, std::int32_t kept,
                   double longest) {
  double limit = longest;
  for (const std::int32_t v : neighbours(work.surface, gone)) {
    limit = std::max(limit, edge_length(work, gone, v));
  }
  return std::ranges::all_of(work.replacement.made, [&](const FaceTriangle& t) {
    return std::ranges::all_of(
        t.nodes, [&](std::int32_t v) { return v == kept || edge_length(work, kept, v) <= limit; });
  });
}

/// The curve's new edge lies near the curve, and the vertex that goes near the edge.
bool curve_allows(const RemeshingWork& work, std::int32_t gone, std::int32_t kept) {
  const ChangingSurface& surface = work.surface;
  const Vertices ends = surface.feature_neighbours(gone);
  const std::int32_t before = ends[0] == kept ? ends[1] : ends[0];
  const Vec3& from = surface.at(before);
  const Vec3& to = surface.at(kept);
  const SurfaceVertex& vertex = surface.vertex(gone);
  const double tolerance = tolerance_at(work, vertex);
  if (distance(nearest_on_segment(surface.at(gone), from, to), surface.at(gone)) > tolerance) {
    return false;
  }
  for (const double share : {0.25, 0.5, 0.75}) {
    if (!work.shape.on_curve(vertex.home, from + share * (to - from), tolerance, vertex.foot))
      return false;
  }
  return true;
}

bool leaves_near(const RemeshingWork& work, std::int32_t gone) {
  const Vec3& at = work.surface.at(gone);
  const double tolerance = tolerance_at(work, work.surface.vertex(gone));
  return std::ranges::any_of(work.replacement.made, [&](const FaceTriangle& t) {
    const TrianglePoints c = work.surface.points(t.nodes);
    return distance2_to_triangle(at, c[0], c[1], c[2]) <= tolerance * tolerance;
  });
}

}  // namespace

bool collapse_edge(RemeshingWork& work, std::int32_t gone, std::int32_t kept, double longest,
                   double least_shape) {
  ChangingSurface& surface = work.surface;
  const Vertices on = surface.triangles_on(gone, kept);
  if (on.empty() || !kinds_allow(surface, on, gone, kept)) return false;
  const Vertices opposite = opposite_vertices(surface, on, gone, kept);
  if (!topology_allows(surface, on, opposite, gone, kept)) return false;
  make_ring(work, on, opposite, gone, kept);
  if (!lengths_allow(work, gone, kept, longest)) return false;
  const double least = std::min(least_shape, worst_shape(surface, work.replacement.removed));
  if (worst_shape(surface, work.replacement.made) < least) return false;
  if (surface.vertex(gone).kind == VertexKind::on_curve && !curve_allows(work, gone, kept))
    return false;
  if (!leaves_near(work, gone) || !lies_on_input(work, kept) || !meets_nothing(work)) return false;
  replace(work);
  surface.remove_vertex(gone);
  return true;
}

}  // namespace tetfarm
