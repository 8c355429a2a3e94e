#include "mesh/volume/kernel_point.h"

#include <algorithm>
#include <vector>

#include "mesh/geometry/predicates.h"
#include "mesh/volume/deepest_point.h"

namespace tetfarm {
namespace {

double smallest_orientation(std::span<const VisibleFace> faces, const Vec3& x) {
  double smallest = HUGE_VAL;
  for (const auto& [a, b, c] : faces) smallest = std::min(smallest, orient3d(a, b, c, x));
  return smallest;
}

/// Distances are those of the exact predicate, which are right to the last digits also where
/// `origin` nearly lies on the planes.
std::vector<HalfSpace> half_spaces(std::span<const VisibleFace> faces, const Vec3& origin) {
  std::vector<HalfSpace> planes;
  for (const auto& [a, b, c] : faces) {
    const Vec3 normal = cross(b - a, c - a);
    const double length = norm(normal);
    if (length > 0) planes.push_back({normal / length, orient3d(a, b, c, origin) / length});
  }
  return planes;
}

}  // namespace

std::optional<Vec3> kernel_point(std::span<const VisibleFace> faces, const Vec3& start) {
  double reach = 0;
  for (const VisibleFace& face : faces) {
    for (const Vec3& p : face) reach = std::max(reach, distance(p, start));
  }
  Vec3 place = start;
  // Each time nearer, so that rounding has less and less to say.
  constexpr int tries = 4;
  for (int i = 0; i < tries && reach > 0; ++i) {
    const Vec3 step = deepest_point(half_spaces(faces, place), reach);
    place += step;
    if (smallest_orientation(faces, place) > 0) return place;
    reach = std::min(0.1 * reach, 4 * norm(step));
  }
  return std::nullopt;
}

}  // namespace tetfarm
