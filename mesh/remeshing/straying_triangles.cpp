#include "mesh/remeshing/straying_triangles.h"

#include <array>

#include "mesh/remeshing/edge_split.h"
#include "mesh/remeshing/triangle_normal.h"

namespace tetfarm {
namespace {

/// Whichever way the input looks there.
constexpr double any_cosine = -2;

constexpr int most_sweeps = 4;

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
  std::array<std::int32_t, 4> guesses{-1, -1, -1, -1};
  for (std::size_t k = 0; k < 3; ++k) {
    const SurfaceVertex& vertex = work.surface.vertex(t.nodes[k]);
    if (vertex.kind == VertexKind::smooth) guesses[k + 1] = vertex.foot;
  }
  for (int i = 0; i <= parts; ++i) {
    for (int j = 0; i + j <= parts; ++j) {
      const std::array<int, 3> shares{parts - i - j, i, j};
      if (is_on_feature(t, shares)) continue;
      const Vec3 p = (shares[0] * c[0] + shares[1] * c[1] + shares[2] * c[2]) / parts;
      guesses[0] = work.shape.near_on_face(t.face, p, normal, any_cosine, tolerance, guesses);
      if (guesses[0] < 0) return true;
    }
  }
  return false;
}

/// The ends of the longest edge.
std::array<std::int32_t, 2> longest_edge_of(const ChangingSurface& surface, const Triangle& t) {
  std::array<std::int32_t, 2> longest{t[0], t[1]};
  double most2 = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double length2 = norm2(surface.at(t[(k + 1) % 3]) - surface.at(t[k]));
    if (length2 <= most2) continue;
    most2 = length2;
    longest = {t[k], t[(k + 1) % 3]};
  }
  return longest;
}

}  // namespace

std::vector<std::int32_t> straying_triangles(const RemeshingWork& work, double tolerance) {
  std::vector<std::int32_t> found;
  for (std::int32_t t = 0; t < work.surface.triangle_end(); ++t) {
    if (work.surface.is_there(t) && strays(work, work.surface.triangle(t), tolerance)) {
      found.push_back(t);
    }
  }
  return found;
}

std::int64_t split_straying_triangles(RemeshingWork& work, double tolerance) {
  std::int64_t splits = 0;
  for (int sweep = 0; sweep < most_sweeps; ++sweep) {
    const std::int64_t before = splits;
    const std::uint64_t then = work.surface.now();
    for (const std::int32_t t : straying_triangles(work, tolerance)) {
      // Its number may be that of one that came when a neighbour was split.
      if (!work.surface.is_there(t)) continue;
      const auto [a, b] = longest_edge_of(work.surface, work.surface.triangle(t).nodes);
      if (work.surface.has_new_triangle(then, a, b)) continue;
      if (split_edge(work, a, b)) ++splits;
    }
    if (splits == before) break;
  }
  return splits;
}

}  // namespace tetfarm
