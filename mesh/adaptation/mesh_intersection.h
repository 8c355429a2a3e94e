/// What the triangles of one mesh cut out of those of another: the convex polygons in which they
/// overlap, with the integrals over each that a piecewise linear field needs.
///
/// Source: F. Alauzet, M. Mehrenberger, "P1-conservative solution interpolation on unstructured
/// triangular meshes" (2010): the overlap goes from neighbour to neighbour. Departs: a triangle is
/// clipped by the three sides of the other, carrying its barycentric coordinates, so that values
/// on a polygon stay between those of the nodes whatever the shape of the triangle; and whether
/// triangles touch at all is decided exactly.
/// Polygons are reached through triangles that touch, from where the nodes lie: not through a wall.
/// Cost: some 0.3 microseconds a pair of triangles that touch. Pairs are counted, and there may be
/// a thousand for each triangle of the two meshes.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/planar/triangle_complex.h"

namespace tetfarm {

/// The overlap of two triangles.
struct IntersectionPiece {
  std::int32_t triangle = -1;  ///< of the background
  double area = 0;
  Vec2 moment;                     ///< the integral of the place, from node 0 of the other triangle
  std::array<double, 3> shares{};  ///< the integrals of the barycentric coordinates of `triangle`
};

/// The overlap of triangles of any turning; area 0 where there is none.
IntersectionPiece intersection_of(const std::array<Vec2, 3>& background,
                                  const std::array<Vec2, 3>& other);

/// Work space too: keep one for all triangles.
class MeshIntersection {
 public:
  /// Keeps references. `most_pairs`: for each triangle of the two. @pre both valid.
  MeshIntersection(const TriangleComplex& background, const TriangleComplex& target,
                   std::int64_t most_pairs = 1000);

  /// The pieces of a triangle of the target, as they are met from the seeds: triangles of the
  /// background in or near it. @throws InvalidInput when there have been too many pairs.
  std::span<const IntersectionPiece> pieces_of(std::int32_t triangle,
                                               std::span<const std::int32_t> seeds);

 private:
  std::array<Vec2, 3> corners_of(const TriangleComplex& complex, std::int32_t triangle) const;
  void reach(std::int32_t triangle);

  const TriangleComplex& background_;
  const TriangleComplex& target_;
  std::vector<std::int32_t> stamps_;
  std::int32_t stamp_ = 0;
  std::vector<std::int32_t> reached_;
  std::vector<IntersectionPiece> pieces_;
  std::int64_t most_pairs_ = 0;
  std::int64_t pairs_left_ = 0;
};

}  // namespace tetfarm
