/// Triangles of a chain: each as often as what lies there faces its way.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "mesh/core/surface_mesh.h"
#include "mesh/geometry/triangle_intersection.h"

namespace tetfarm {

struct ChainTriangle {
  Triangle nodes{};
  std::int32_t times = 1;   ///< how often it is there, of what lies on each other; not 0
  std::int32_t patch = 0;   ///< of the first that faces as it does
  bool is_divided = false;  ///< no triangle of the input
  bool is_clear = false;    ///< met none when last looked at, and has not changed since
};

struct TriangleChain {
  std::vector<Vec3> vertices;
  std::vector<ChainTriangle> triangles;

  TrianglePoints points_of(std::int32_t triangle) const {
    return triangle_points(vertices, triangles[static_cast<std::size_t>(triangle)].nodes);
  }
};

/// Equal vertices become the first of them, triangles that have one twice or no area go, and of
/// those with the same corners one stays, as often as they are there in sum, or none. Cost:
/// O(n log n).
void merge_equals(TriangleChain& chain);

/// Each two become the first of all that are so joined. Cost: O(n).
void join_vertices(TriangleChain& chain, const std::vector<std::array<std::int32_t, 2>>& pairs);

/// Numbers of two triangles, the smaller first.
using TrianglePair = std::array<std::int32_t, 2>;

/// Those that share points beyond corners and edges that both have, sorted; nothing where there are
/// more than 10 for each triangle and 200,000. Those that are clear are not looked at together;
/// after that, those in no pair are clear. @pre triangles have area. Exact.
std::optional<std::vector<TrianglePair>> meeting_pairs(TriangleChain& chain);

}  // namespace tetfarm
