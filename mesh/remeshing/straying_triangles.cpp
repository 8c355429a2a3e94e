#include "mesh/remeshing/straying_triangles.h"

#include <algorithm>

#include "mesh/remeshing/triangle_normal.h"

namespace tetfarm {
namespace {

/// Whichever way the input looks there.
constexpr double any_cosine = -2;

bool strays(const RemeshingWork& work, const FaceTriangle& t, double tolerance) {
  if (work.shape.plane(t.face)) return false;
  const TrianglePoints c = work.surface.points(t.nodes);
  const Vec3 normal = normalized(doubled_area(c));
  const Vec3 middle = (c[0] + c[1] + c[2]) / 3.0;
  return std::ranges::any_of(c, [&](const Vec3& corner) {
    return work.shape.near_on_face(t.face, 0.5 * (corner + middle), normal, any_cosine, tolerance,
                                   -1) < 0;
  });
}

}  // namespace

std::int64_t straying_triangles(const RemeshingWork& work, double tolerance) {
  std::int64_t count = 0;
  for (std::int32_t t = 0; t < work.surface.triangle_end(); ++t) {
    if (work.surface.is_there(t) && strays(work, work.surface.triangle(t), tolerance)) ++count;
  }
  return count;
}

}  // namespace tetfarm
