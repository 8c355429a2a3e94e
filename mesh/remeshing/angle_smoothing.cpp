#include "mesh/remeshing/angle_smoothing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "mesh/remeshing/triangle_normal.h"
#include "mesh/remeshing/vertex_move.h"

namespace tetfarm {
namespace {

/// Of the spacing.
constexpr std::array<double, 5> lengths_of_steps = {0.4, 0.24, 0.12, 0.06, 0.03};
constexpr double root_of_half = 0.70710678118654757;
constexpr std::array<std::array<double, 2>, 8> ways = {{{1, 0},
                                                        {root_of_half, root_of_half},
                                                        {0, 1},
                                                        {-root_of_half, root_of_half},
                                                        {-1, 0},
                                                        {-root_of_half, -root_of_half},
                                                        {0, -1},
                                                        {root_of_half, -root_of_half}}};
/// A step makes the cosine of the smallest angle smaller by as much: 0.05 degrees at 30.
constexpr double least_cosine_gain = 4e-4;
constexpr int most_steps_of_vertex = 12;

/// The cosine of the smallest angle of a triangle.
double largest_cosine(const TrianglePoints& c) {
  double largest = -1;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 u = c[(k + 1) % 3] - c[k];
    const Vec3 v = c[(k + 2) % 3] - c[k];
    const double lengths = std::sqrt(norm2(u) * norm2(v));
    largest = std::max(largest, lengths > 0 ? dot(u, v) / lengths : 1);
  }
  return largest;
}

double largest_cosine(const ChangingSurface& surface, std::int32_t v) {
  double largest = -1;
  for (const std::int32_t t : surface.ring(v)) {
    largest = std::max(largest, largest_cosine(surface.points(surface.triangle(t).nodes)));
  }
  return largest;
}

/// Two directions across the normal, of length 1.
std::array<Vec3, 2> tangents_of(const Vec3& normal) {
  const Vec3 size{std::fabs(normal.x), std::fabs(normal.y), std::fabs(normal.z)};
  const Vec3 axis = size.x <= size.y && size.x <= size.z ? Vec3{1, 0, 0}
                    : size.y <= size.z                   ? Vec3{0, 1, 0}
                                                         : Vec3{0, 0, 1};
  const Vec3 first = normalized(cross(normal, axis));
  return {first, normalized(cross(normal, first))};
}

/// The vertex where a step leads, on the input; nothing where there is none.
std::optional<InputFoot> foot_of_step(const RemeshingWork& work, std::int32_t v, const Vec3& to,
                                      const Vec3& normal) {
  const SurfaceVertex& vertex = work.surface.vertex(v);
  if (work.shape.plane(vertex.home)) return InputFoot{to, vertex.foot, 0};
  return work.shape.on_face(vertex.home, to, normal, vertex.spacing, vertex.foot);
}

/// The step that makes the smallest angle largest.
std::optional<InputFoot> best_step(RemeshingWork& work, std::int32_t v, double cosine) {
  ChangingSurface& surface = work.surface;
  const Vec3 before = surface.at(v);
  const Vec3 normal = normal_at(surface, v, surface.vertex(v).home);
  const auto [first, second] = tangents_of(normalized(normal));
  std::optional<InputFoot> best;
  double best_cosine = cosine - least_cosine_gain;
  for (const double step : lengths_of_steps) {
    const double length = step * surface.vertex(v).spacing;
    for (const auto& [along, across] : ways) {
      const Vec3 to = before + length * (along * first + across * second);
      const std::optional<InputFoot> foot = foot_of_step(work, v, to, normal);
      if (!foot) continue;
      surface.try_at(v, foot->at);
      const double here = largest_cosine(surface, v);
      if (here < best_cosine) {
        best_cosine = here;
        best = foot;
      }
    }
  }
  surface.try_at(v, before);
  return best;
}

bool move_to(RemeshingWork& work, std::int32_t v, const InputFoot& foot) {
  const VertexPlace before = try_vertex(work, v, {foot.at, foot.item});
  return keep_or_put_back(work, v, before, true);
}

}  // namespace

std::int64_t raise_angles(RemeshingWork& work, double cosine_wanted) {
  std::int64_t moved = 0;
  for (std::int32_t v = 0; v < work.surface.vertex_end(); ++v) {
    if (work.surface.ring(v).empty() || work.surface.vertex(v).kind != VertexKind::smooth) continue;
    bool has_moved = false;
    for (int step = 0; step < most_steps_of_vertex; ++step) {
      const double cosine = largest_cosine(work.surface, v);
      if (cosine <= cosine_wanted) break;
      const std::optional<InputFoot> to = best_step(work, v, cosine);
      if (!to || !move_to(work, v, *to)) break;
      has_moved = true;
    }
    if (has_moved) ++moved;
  }
  return moved;
}

}  // namespace tetfarm
