#include "mesh/inspect/shifted_ray.h"

#include "mesh/geometry/predicates.h"

namespace tetfarm {
namespace {

int sign(double x) { return (x > 0) - (x < 0); }

Vec2 along_x(const Vec3& p) { return {p.y, p.z}; }

/// The side of the line uv on which p lies when shifted by (ε, ε²); 0 only when u = v.
int shifted_side(const Vec2& u, const Vec2& v, const Vec2& p) {
  const int side = sign(orient2d(u, v, p));
  if (side != 0) return side;
  return u.y != v.y ? sign(u.y - v.y) : sign(v.x - u.x);
}

/// Whether the points, seen along an axis, leave p in the closed triangle or on its line.
bool is_in_shadow(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& p) {
  const int ab = sign(orient2d(a, b, p));
  const int bc = sign(orient2d(b, c, p));
  const int ca = sign(orient2d(c, a, p));
  return (ab >= 0 && bc >= 0 && ca >= 0) || (ab <= 0 && bc <= 0 && ca <= 0);
}

}  // namespace

int ray_passes(const Vec3& p, const TrianglePoints& t) {
  const Vec2 q = along_x(p);
  const int side = shifted_side(along_x(t[0]), along_x(t[1]), q);
  if (side == 0 || shifted_side(along_x(t[1]), along_x(t[2]), q) != side ||
      shifted_side(along_x(t[2]), along_x(t[0]), q) != side) {
    return 0;
  }
  return sign(orient3d(t[0], t[1], t[2], p)) * side < 0 ? side : 0;
}

bool is_on_triangle(const Vec3& p, const TrianglePoints& t) {
  if (orient3d(t[0], t[1], t[2], p) != 0) return false;
  for (int axis = 0; axis < 3; ++axis) {
    const auto seen = [axis](const Vec3& v) { return Vec2{v[(axis + 1) % 3], v[(axis + 2) % 3]}; };
    if (!is_in_shadow(seen(t[0]), seen(t[1]), seen(t[2]), seen(p))) return false;
  }
  return true;
}

}  // namespace tetfarm
