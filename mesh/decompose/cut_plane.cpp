#include "mesh/decompose/cut_plane.h"

#include <cmath>

namespace tetfarm {

CutPlane make_cut_plane(const Vec3& unit_normal, double offset) {
  const Vec3 size{std::fabs(unit_normal.x), std::fabs(unit_normal.y), std::fabs(unit_normal.z)};
  // The axis after the largest component is never close to the normal, and cycles x, y, z.
  const int main_axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  Vec3 helper;
  helper[(main_axis + 1) % 3] = 1;
  const Vec3 u = normalized(helper - dot(helper, unit_normal) * unit_normal);
  return {unit_normal, u, cross(unit_normal, u), offset};
}

}  // namespace tetfarm
