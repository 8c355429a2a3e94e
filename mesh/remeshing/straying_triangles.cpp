#include "mesh/remeshing/straying_triangles.h"

#include <array>

#include "mesh/remeshing/triangle_normal.h"

namespace tetfarm {
namespace {

/// Whichever way the input looks there.
constexpr double any_cosine = -2;

/// Points are this many to an edge, and as many to lines beside it.
constexpr int parts = 6;

/// Whether a point is a corner or on a feature edge. @param shares of the corners.
bool is_on_feature(const FaceTriangle& t, const std::array<int, 3>& shares) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (shares[k] == parts) return true;
    if (shares[(k + 2) % 3] == 0 && is_feature_side(t, k)) return true;
  }
  return false;
}

bool strays(const RemeshingWork& work, const FaceTriangle& t, double tolerance) {
  if (work.shape.plane(t.face)) return false;
  const TrianglePoints c = work.surface.points(t.nodes);
  const Vec3 normal = normalized(doubled_area(c));
  std::int32_t below = -1;
  for (int i = 0; i <= parts; ++i) {
    for (int j = 0; i + j <= parts; ++j) {
      const std::array<int, 3> shares{parts - i - j, i, j};
      if (is_on_feature(t, shares)) continue;
      const Vec3 p = (shares[0] * c[0] + shares[1] * c[1] + shares[2] * c[2]) / parts;
      below = work.shape.near_on_face(t.face, p, normal, any_cosine, tolerance, below);
      if (below < 0) return true;
    }
  }
  return false;
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
