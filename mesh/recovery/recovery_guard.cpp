#include "mesh/recovery/recovery_guard.h"

#include <algorithm>

namespace tetfarm {
namespace {

bool holds(const Triangle& t, std::int32_t v) { return t[0] == v || t[1] == v || t[2] == v; }

bool are_opposed(double s, double t) { return (s > 0 && t < 0) || (s < 0 && t > 0); }

}  // namespace

bool segments_cross(const LocalRemeshing& mesh, std::int32_t a, std::int32_t b, std::int32_t c,
                    std::int32_t d) {
  if (mesh.orient(a, b, c, d) != 0) return false;
  const FinePoint pa = mesh.fine_point(a), pb = mesh.fine_point(b);
  const FinePoint pc = mesh.fine_point(c), pd = mesh.fine_point(d);
  // In one plane: they cross when they do in a projection in which they are not seen edge on.
  for (int axis = 0; axis < 3; ++axis) {
    const double sc = orient2d_along(axis, pa, pb, pc), sd = orient2d_along(axis, pa, pb, pd);
    if (sc == 0 && sd == 0) continue;
    return are_opposed(sc, sd) &&
           are_opposed(orient2d_along(axis, pc, pd, pa), orient2d_along(axis, pc, pd, pb));
  }
  return false;
}

bool segment_crosses_triangle(const LocalRemeshing& mesh, std::int32_t p, std::int32_t q,
                              const Triangle& triangle) {
  const auto [a, b, c] = triangle;
  const double at_p = mesh.orient(a, b, c, p);
  if (at_p == 0 || !are_opposed(at_p, mesh.orient(a, b, c, q))) return false;
  const std::array<double, 3> turn = {mesh.orient(p, q, a, b), mesh.orient(p, q, b, c),
                                      mesh.orient(p, q, c, a)};
  const auto [low, high] = std::minmax({turn[0], turn[1], turn[2]});
  return (low >= 0 || high <= 0) && std::count(turn.begin(), turn.end(), 0.0) <= 1;
}

RecoveryGuard RecoveryGuard::of_edge(const LocalRemeshing& mesh, std::int32_t a, std::int32_t b) {
  RecoveryGuard guard(mesh);
  guard.edge_ = {a, b};
  return guard;
}

RecoveryGuard RecoveryGuard::of_face(const LocalRemeshing& mesh, const Triangle& face) {
  RecoveryGuard guard(mesh);
  guard.face_ = face;
  return guard;
}

bool RecoveryGuard::crosses_edge(std::int32_t u, std::int32_t v) const {
  if (edge_) {
    const auto [a, b] = *edge_;
    if (u == a || u == b || v == a || v == b) return false;
    return segments_cross(mesh_, a, b, u, v);
  }
  if (!face_) return false;
  const Triangle& f = *face_;
  if (holds(f, u) && holds(f, v)) return false;
  if (segment_crosses_triangle(mesh_, u, v, f)) return true;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::int32_t p = f[k], q = f[(k + 1) % 3];
    if (u == p || u == q || v == p || v == q) continue;
    if (segments_cross(mesh_, p, q, u, v)) return true;
  }
  return false;
}

bool RecoveryGuard::crosses_face(std::int32_t u, std::int32_t v, std::int32_t w) const {
  if (!edge_) return false;
  const auto [a, b] = *edge_;
  const Triangle face = {u, v, w};
  if (holds(face, a) || holds(face, b)) return false;
  return segment_crosses_triangle(mesh_, a, b, face);
}

}  // namespace tetfarm
