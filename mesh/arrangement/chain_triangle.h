/// Triangles of a chain: each as often as what lies there faces its way.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "base/disjoint_sets.h"
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

/// The smaller number of a vertex first.
using ChainEdge = std::array<std::int32_t, 2>;

/// The edge of a triangle that does not have the corner.
ChainEdge edge_against(const Triangle& nodes, std::size_t corner);

/// Adds what becomes of a triangle one of whose edges gets points, given with the edge's ends from
/// its smaller number on. A piece that would have a corner twice, where a point is the third
/// corner, is folded onto its edges and is none.
void add_pieces(const ChainTriangle& whole, const ChainEdge& edge,
                const std::vector<std::int32_t>& points, std::vector<ChainTriangle>& pieces);

/// Removes those that are marked; the others keep their order. Cost: O(n).
void remove_triangles(TriangleChain& chain, const std::vector<char>& is_gone);

/// Equal vertices become the first of them, triangles that have one twice or no area go, and of
/// those with the same corners one stays, as often as they are there in sum, or none. Cost:
/// O(n log n).
void merge_equals(TriangleChain& chain);

/// Each two become the first of all that are so joined. Cost: O(n).
void join_vertices(TriangleChain& chain, const std::vector<ChainEdge>& pairs);

/// The marked items of each set, sorted; the sets in the order of their first. Cost: O(n).
std::vector<std::vector<std::int32_t>> groups_of_marked(DisjointSets& sets,
                                                        const std::vector<char>& is_marked);

/// Numbers of two triangles, the smaller first.
using TrianglePair = std::array<std::int32_t, 2>;

/// Those that share points beyond corners and edges that both have, sorted; nothing where there are
/// more than 10 for each triangle and 200,000. Those that are clear are not looked at together;
/// after that, those in no pair are clear. @pre triangles have area. Exact.
std::optional<std::vector<TrianglePair>> meeting_pairs(TriangleChain& chain);

}  // namespace tetfarm
