#include "mesh/remeshing/surface_replacement.h"

#include <algorithm>
#include <array>
#include <optional>

#include "base/check.h"
#include "mesh/remeshing/triangle_normal.h"

namespace tetfarm {
namespace {

/// Least cosines of the angle between a triangle and the input near its middle: more than 60 and 72
/// degrees are a fold.
constexpr double plane_cosine = 0.5;
constexpr double curved_cosine = 0.3;

/// Rounding cannot turn a triangle of a better shape over.
constexpr double surely_not_flat = 1e-6;

/// Cosine of the angle between normals, 25 degrees, up to which neighbours do not fold.
constexpr double even_cosine = 0.9;

/// Cosine of the angle, 72 degrees, by which no part of the input near a change may turn away from
/// it, for nothing else to be there; and how near that is, in tolerances of the work.
constexpr double alone_cosine = 0.3;
constexpr double tolerances_around = 2;

constexpr double sqrt_3 = 1.7320508075688772;

/// @param input of a triangle of the input; zero where it has no sure direction.
bool turns_away(const Vec3& input, const Vec3& normal) {
  return norm2(input) > 0 && dot(input, normal) < curved_cosine;
}

bool lies_on_input(const RemeshingWork& work, const FaceTriangle& t, std::int32_t hub) {
  const TrianglePoints c = work.surface.points(t.nodes);
  const Vec3 normal = normalized(doubled_area(c));
  if (const std::optional<Vec3>& plane = work.shape.plane(t.face)) {
    return dot(normal, *plane) > plane_cosine;
  }
  std::array<std::int32_t, 4> guesses{-1, -1, -1, -1};
  for (std::size_t k = 0; k < 3; ++k) {
    const SurfaceVertex& vertex = work.surface.vertex(t.nodes[k]);
    if (vertex.kind != VertexKind::smooth) continue;
    const std::int32_t guess = guesses[k + 1] = vertex.foot;
    // Where walls are near each other, what lies under a triangle that is folded over may be the
    // other wall, which looks the same way.
    if (guess >= 0 && turns_away(work.shape.normal(guess), normal)) return false;
  }
  const std::int32_t below = work.shape.near_on_face(t.face, (c[0] + c[1] + c[2]) / 3.0, normal,
                                                     curved_cosine, work.tolerance, guesses);
  if (below < 0) return false;
  guesses[0] = below;
  const std::size_t k = corner_of(t.nodes, hub);
  if (is_feature_side(t, k)) return true;
  const Vec3 middle = 0.5 * (c[k] + c[(k + 1) % 3]);
  return work.shape.near_on_face(t.face, middle, normal, 0, work.tolerance, guesses) >= 0;
}

/// The mean normal of what is made, where all of it is nearly across it.
std::optional<Vec3> common_normal(const RemeshingWork& work) {
  Vec3 sum;
  for (const FaceTriangle& t : work.replacement.made)
    sum += doubled_area(work.surface.points(t.nodes));
  const Vec3 mean = normalized(sum);
  for (const FaceTriangle& t : work.replacement.made) {
    const Vec3 normal = doubled_area(work.surface.points(t.nodes));
    if (!(dot(normal, mean) > even_cosine * norm(normal))) return std::nullopt;
  }
  return mean;
}

/// Whether a triangle next to those made, in their face, is nearly across their normal: then it
/// does not fold back over them.
bool goes_on_evenly(const RemeshingWork& work, const FaceTriangle& other, const Vec3& normal) {
  const std::vector<FaceTriangle>& made = work.replacement.made;
  if (other.face != made.front().face) return false;
  const Vec3 area = doubled_area(work.surface.points(other.nodes));
  if (!(dot(area, normal) > even_cosine * norm(area))) return false;
  return std::ranges::any_of(made, [&](const FaceTriangle& m) {
    return std::ranges::any_of(m.nodes, [&](std::int32_t v) { return has_corner(other.nodes, v); });
  });
}

bool meet(const ChangingSurface& surface, const Triangle& a, const Triangle& b) {
  return surface.box(a).overlaps(surface.box(b)) &&
         triangles_meet_beyond_shared(surface.places(), a, b);
}

bool meet_each_other(const RemeshingWork& work) {
  const std::vector<FaceTriangle>& made = work.replacement.made;
  for (std::size_t i = 0; i < made.size(); ++i) {
    for (std::size_t j = i + 1; j < made.size(); ++j) {
      if (meet(work.surface, made[i].nodes, made[j].nodes)) return true;
    }
  }
  return false;
}

/// No triangle made meets one near it.
bool meets_none_near(RemeshingWork& work, const Box3& all, const std::optional<Vec3>& common) {
  const ChangingSurface& surface = work.surface;
  const SurfaceReplacement& change = work.replacement;
  work.near.clear();
  surface.tree().query(all, [&work](std::int32_t t) { work.near.push_back(t); });
  return std::ranges::none_of(work.near, [&](std::int32_t t) {
    const FaceTriangle& other = surface.triangle(t);
    if (std::ranges::find(change.removed, t) != change.removed.end()) return false;
    if (common && goes_on_evenly(work, other, *common)) return false;
    return std::ranges::any_of(
        change.made, [&](const FaceTriangle& m) { return meet(surface, m.nodes, other.nodes); });
  });
}

/// Whether the input near the box looks one way. What is remeshed lies near it and looks as it
/// does: nothing there folds over, and there is no other wall.
bool is_alone(const RemeshingWork& work, const Box3& box, const Vec3& normal) {
  const double reach = tolerances_around * work.tolerance;
  Box3 wider;
  wider.add(box.low - Vec3{reach, reach, reach});
  wider.add(box.high + Vec3{reach, reach, reach});
  return work.shape.looks_one_way(wider, normal, alone_cosine);
}

}  // namespace

double tolerance_at(const RemeshingWork& work, const SurfaceVertex& vertex) {
  if (vertex.foot < 0) return work.tolerance;
  return work.tolerance * (vertex.kind == VertexKind::on_curve
                               ? work.shape.share_at_edge(vertex.foot)
                               : work.shape.share_at(vertex.foot));
}

double triangle_shape(const TrianglePoints& t) {
  const Vec3 u = t[1] - t[0];
  const Vec3 v = t[2] - t[0];
  const double squares = norm2(u) + norm2(v) + norm2(t[2] - t[1]);
  return squares > 0 ? 2 * sqrt_3 * norm(cross(u, v)) / squares : 0;
}

double worst_shape(const ChangingSurface& surface, std::span<const std::int32_t> triangles) {
  double worst = 1;
  for (const std::int32_t t : triangles) {
    worst = std::min(worst, triangle_shape(surface.points(surface.triangle(t).nodes)));
  }
  return worst;
}

double worst_shape(const ChangingSurface& surface, const std::vector<FaceTriangle>& triangles) {
  double worst = 1;
  for (const FaceTriangle& t : triangles) {
    worst = std::min(worst, triangle_shape(surface.points(t.nodes)));
  }
  return worst;
}

Vec3 normal_at(const ChangingSurface& surface, std::int32_t v, std::int32_t face) {
  Vec3 sum;
  for (const std::int32_t t : surface.ring(v)) {
    const FaceTriangle& triangle = surface.triangle(t);
    if (triangle.face != face) continue;
    sum += doubled_area(surface.points(triangle.nodes));
  }
  return sum;
}

bool lies_on_input(const RemeshingWork& work, std::int32_t hub) {
  return std::ranges::all_of(work.replacement.made,
                             [&](const FaceTriangle& t) { return lies_on_input(work, t, hub); });
}

bool meets_nothing(RemeshingWork& work) {
  const ChangingSurface& surface = work.surface;
  const SurfaceReplacement& change = work.replacement;
  const bool is_simple = change.fills_hole && !work.is_strict;
  if (is_simple && work.shape.plane(change.made.front().face) &&
      worst_shape(surface, change.made) > surely_not_flat) {
    return true;
  }
  Box3 all;
  for (const FaceTriangle& t : change.made) {
    if (is_degenerate(surface.points(t.nodes))) return false;
    all.add(surface.box(t.nodes));
  }
  const std::optional<Vec3> common = is_simple ? common_normal(work) : std::nullopt;
  if (!common) return !meet_each_other(work) && meets_none_near(work, all, common);
  if (is_alone(work, all, *common)) return true;
  return meets_none_near(work, all, common);
}

void replace(RemeshingWork& work) {
  TF_CHECK(!work.replacement.removed.empty());
  for (const std::int32_t t : work.replacement.removed) work.surface.remove_triangle(t);
  for (const FaceTriangle& t : work.replacement.made) work.surface.add_triangle(t);
}

}  // namespace tetfarm
