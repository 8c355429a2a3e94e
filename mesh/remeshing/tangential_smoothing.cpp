#include "mesh/remeshing/tangential_smoothing.h"

#include <algorithm>
#include <optional>
#include <vector>

#include "mesh/remeshing/edge_length.h"
#include "mesh/remeshing/triangle_normal.h"
#include "mesh/remeshing/vertex_move.h"

namespace tetfarm {
namespace {

/// A vertex that would move less than this share of the spacing stays.
constexpr double least_move = 0.02;

Vec3 wanted_in_face(const RemeshingWork& work, std::int32_t v) {
  const ChangingSurface& surface = work.surface;
  Vec3 sum;
  double weights = 0;
  for (const std::int32_t t : surface.ring(v)) {
    const Triangle& nodes = surface.triangle(t).nodes;
    const TrianglePoints c = surface.points(nodes);
    double spacing = 0;
    for (const std::int32_t w : nodes) spacing += surface.vertex(w).spacing;
    const double area = norm(doubled_area(c));
    const double weight = area / (spacing * spacing * spacing * spacing);
    sum += weight * (c[0] + c[1] + c[2]) / 3.0;
    weights += weight;
  }
  return weights > 0 ? sum / weights : surface.at(v);
}

Vec3 wanted_on_curve(const RemeshingWork& work, std::int32_t v) {
  const std::vector<std::int32_t> ends = work.surface.feature_neighbours(v);
  const SurfaceVertex& vertex = work.surface.vertex(v);
  const double to_first = vertex.spacing + work.surface.vertex(ends[0]).spacing;
  const double to_second = vertex.spacing + work.surface.vertex(ends[1]).spacing;
  return (to_second * work.surface.at(ends[0]) + to_first * work.surface.at(ends[1])) /
         (to_first + to_second);
}

std::optional<InputFoot> foot_for(const RemeshingWork& work, std::int32_t v) {
  const SurfaceVertex& vertex = work.surface.vertex(v);
  if (vertex.kind == VertexKind::on_curve) {
    return work.shape.on_curve(vertex.home, wanted_on_curve(work, v), vertex.spacing, vertex.foot);
  }
  const Vec3 wanted = wanted_in_face(work, v);
  if (work.shape.plane(vertex.home)) return InputFoot{wanted, vertex.foot, 0};
  return work.shape.on_face(vertex.home, wanted, normal_at(work.surface, v, vertex.home),
                            vertex.spacing, vertex.foot);
}

/// The edges of a curve's vertex lie near the curve.
bool curve_allows_move(const RemeshingWork& work, std::int32_t v) {
  const SurfaceVertex& vertex = work.surface.vertex(v);
  const Vec3& to = work.surface.at(v);
  const double tolerance = tolerance_at(work, vertex);
  return std::ranges::all_of(work.surface.feature_neighbours(v), [&](std::int32_t end) {
    return work.shape
        .on_curve(vertex.home, 0.5 * (work.surface.at(end) + to), tolerance, vertex.foot)
        .has_value();
  });
}

}  // namespace

bool smooth_vertex(RemeshingWork& work, std::int32_t v, double least_shape) {
  ChangingSurface& surface = work.surface;
  SurfaceVertex& vertex = surface.vertex(v);
  const std::optional<InputFoot> foot = foot_for(work, v);
  if (!foot || distance(foot->at, surface.at(v)) < least_move * vertex.spacing) {
    vertex.settled = surface.now();
    return false;
  }
  const double least = std::min(least_shape, worst_shape(surface, surface.ring(v)));
  const VertexPlace place = try_vertex(work, v, {foot->at, foot->item});
  const bool is_better = worst_shape(surface, surface.ring(v)) >= least;
  const bool is_wanted =
      is_better && (vertex.kind == VertexKind::smooth || curve_allows_move(work, v));
  if (keep_or_put_back(work, v, place, is_wanted)) return true;
  vertex.settled = surface.now();
  return false;
}

std::int64_t smooth_vertices(RemeshingWork& work, double least_shape) {
  std::int64_t moved = 0;
  for (std::int32_t v = 0; v < work.surface.vertex_end(); ++v) {
    const SurfaceVertex& vertex = work.surface.vertex(v);
    if (work.surface.ring(v).empty() || vertex.kind == VertexKind::corner) continue;
    // Nothing round it has changed since it was found to be in its place.
    if (vertex.settled >= work.surface.changed(v)) continue;
    if (smooth_vertex(work, v, least_shape)) ++moved;
  }
  return moved;
}

void measure_spacings(RemeshingWork& work) {
  for (std::int32_t v = 0; v < work.surface.vertex_end(); ++v) {
    SurfaceVertex& vertex = work.surface.vertex(v);
    if (!vertex.has_moved) continue;
    vertex.spacing = work.spacing.at(work.surface.at(v));
    vertex.has_moved = false;
  }
}

}  // namespace tetfarm
