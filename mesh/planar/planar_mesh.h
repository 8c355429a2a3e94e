/// The 2D mesher of the cuts: a region bounded by closed loops, filled with triangles of the
/// spacing.
///
/// Source: thesis 4.3.1.8 and chapter 3 (the same kernel); constrained Delaunay with exact
/// predicates. Boundary edges are never split, every boundary point stays where it is, bit by bit.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "mesh/geometry/predicates.h"

namespace tetfarm {

/// Closed loops of edges between `points`; the region lies to the left of each directed edge.
/// A point may not lie on an edge that it does not belong to; edges meet at end points only.
struct PlanarRegion {
  std::vector<Vec2> points;
  std::vector<std::array<std::int32_t, 2>> edges;
};

/// Triangles anticlockwise. The first points are the region's, in order.
struct PlanarMesh {
  std::vector<Vec2> points;
  std::vector<std::array<std::int32_t, 3>> triangles;
};

/// Target edge length at a point of the plane.
using PlanarSpacing = std::function<double(const Vec2&)>;

struct PlanarFailure {
  std::string reason;
  std::vector<Vec2> where;
};

struct PlanarOptions {
  /// Pairs of boundary points that must not be joined by an inner edge of the result: such a chord
  /// is split by a point near its middle.
  std::vector<std::array<std::int32_t, 2>> forbidden_chords;
  /// More triangles than this are refused.
  std::int64_t max_triangles = 20'000'000;
};

/// Constrained Delaunay triangulation of the region, with interior points by the spacing and
/// smoothing. Returns the failure when edges cross, a point lies on an edge, two points coincide, a
/// loop does not close, loops disagree about the inside, the spacing is not positive, or there
/// would be too many triangles; `where` then names every place found (at most 100). Interior points
/// keep about 0.7 spacing from each other and the boundary; no triangle of two boundary edges is
/// avoided by force. Points that no edge uses stay as inner nodes where they are if they lie in the
/// region. Two loops may touch in a vertex. Deterministic; the order of the edges does not matter.
/// Cost: O(n log n).
struct PlanarResult {
  PlanarMesh mesh;
  std::optional<PlanarFailure> failure;
};
PlanarResult mesh_region(const PlanarRegion& region, const PlanarSpacing& spacing,
                         const PlanarOptions& options = {});

}  // namespace tetfarm
