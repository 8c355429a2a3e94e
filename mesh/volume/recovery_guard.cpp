#include "mesh/volume/recovery_guard.h"

#include "mesh/geometry/predicates.h"
#include "mesh/geometry/triangle_intersection.h"

namespace tetfarm {
namespace {

Vec2 without_axis(const Vec3& p, int axis) { return {p[(axis + 1) % 3], p[(axis + 2) % 3]}; }

bool holds(const Triangle& t, std::int32_t v) { return t[0] == v || t[1] == v || t[2] == v; }

}  // namespace

bool segments_cross(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  if (orient3d(a, b, c, d) != 0) return false;
  // In one plane: they cross when they do in a projection in which they are not seen edge on.
  for (int axis = 0; axis < 3; ++axis) {
    const Vec2 pa = without_axis(a, axis), pb = without_axis(b, axis);
    const Vec2 pc = without_axis(c, axis), pd = without_axis(d, axis);
    const double sc = orient2d(pa, pb, pc), sd = orient2d(pa, pb, pd);
    const double sa = orient2d(pc, pd, pa), sb = orient2d(pc, pd, pb);
    if (sc == 0 && sd == 0) continue;
    return ((sc > 0 && sd < 0) || (sc < 0 && sd > 0)) && ((sa > 0 && sb < 0) || (sa < 0 && sb > 0));
  }
  return false;
}

RecoveryGuard RecoveryGuard::of_edge(std::span<const Vec3> points, std::int32_t a, std::int32_t b) {
  RecoveryGuard guard(points);
  guard.edge_ = {a, b};
  return guard;
}

RecoveryGuard RecoveryGuard::of_face(std::span<const Vec3> points, const Triangle& face) {
  RecoveryGuard guard(points);
  guard.face_ = face;
  return guard;
}

bool RecoveryGuard::forbids_edge(std::int32_t u, std::int32_t v) const {
  if (edge_) {
    const auto [a, b] = *edge_;
    if (u == a || u == b || v == a || v == b) return false;
    return segments_cross(at(a), at(b), at(u), at(v));
  }
  const Triangle& f = *face_;
  if (holds(f, u) && holds(f, v)) return false;
  if (segment_crosses_triangle(at(u), at(v), {at(f[0]), at(f[1]), at(f[2])})) return true;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::int32_t p = f[k], q = f[(k + 1) % 3];
    if (u == p || u == q || v == p || v == q) continue;
    if (segments_cross(at(p), at(q), at(u), at(v))) return true;
  }
  return false;
}

bool RecoveryGuard::forbids_face(std::int32_t u, std::int32_t v, std::int32_t w) const {
  if (!edge_) return false;
  const auto [a, b] = *edge_;
  const Triangle face = {u, v, w};
  if (holds(face, a) || holds(face, b)) return false;
  return segment_crosses_triangle(at(a), at(b), {at(u), at(v), at(w)});
}

}  // namespace tetfarm
