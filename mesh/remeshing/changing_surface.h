/// A surface while it is remeshed: triangles go, and others that fill the same hole come.
///
/// Edges may have more than two triangles (sheets between regions), so there are no neighbour
/// links: each vertex knows its triangles. Invariants (complaints_of tells of them):
///  1. a triangle that is there has three different vertices, and is in the ring of each, and in no
///     other; a triangle that is gone has first vertex -1;
///  2. all triangles on an edge agree on whether it is a feature, and an edge that has not exactly
///     two triangles of one face is one;
///  3. the tree holds the box of each triangle that is there;
///  4. a vertex on a curve has exactly two feature edges, a smooth one none, and all triangles of a
///     smooth one are of its home face.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "mesh/core/surface_mesh.h"
#include "mesh/geometry/triangle_intersection.h"
#include "mesh/remeshing/surface_features.h"
#include "mesh/remeshing/triangle_octree.h"
#include "mesh/remeshing/triangle_ring.h"

namespace tetfarm {

/// Bit k of `features`: the edge from nodes[k] to nodes[(k + 1) % 3] is a feature.
struct FaceTriangle {
  Triangle nodes{-1, -1, -1};
  std::int32_t face = 0;
  std::uint8_t features = 0;
};

struct SurfaceVertex {
  VertexKind kind = VertexKind::smooth;
  std::int32_t home = -1;  ///< the face of a smooth vertex, the curve of one on a curve
  std::int32_t foot = -1;  ///< the triangle or edge of the input that it lies on: a first guess
  double spacing = 0;      ///< wanted there, or where it was before it was last moved
  bool has_moved = false;  ///< since then
  /// When it was last found to be in its place, by ChangingSurface::now().
  std::uint64_t settled = 0;
};

class ChangingSurface {
 public:
  explicit ChangingSurface(const Box3& whole) : whole_(whole), tree_(whole) {}

  std::int32_t add_vertex(const Vec3& at, const SurfaceVertex& vertex);
  /// @pre it has no triangles.
  void remove_vertex(std::int32_t v);
  std::int32_t add_triangle(const FaceTriangle& triangle);
  void remove_triangle(std::int32_t t);
  /// Puts a vertex elsewhere for the time being: the tree has its triangles where they were.
  void try_at(std::int32_t v, const Vec3& to) { places_[static_cast<std::size_t>(v)] = to; }
  /// The vertex stays where it was put.
  void settle(std::int32_t v);
  void move_vertex(std::int32_t v, const Vec3& to) {
    try_at(v, to);
    settle(v);
  }

  /// Numbers vertices and triangles anew, those near each other alike, so that what is worked on
  /// together lies together in memory. What has changed when is forgotten: all counts as changed.
  /// Cost: O(n).
  void number_by_place();

  /// The number of changes up to now.
  std::uint64_t now() const { return now_; }
  /// The last change of the triangles of v: one that came, went, or had a vertex moved.
  std::uint64_t changed(std::int32_t v) const { return changed_[static_cast<std::size_t>(v)]; }
  /// Whether a triangle on the edge came after that.
  bool has_new_triangle(std::uint64_t then, std::int32_t a, std::int32_t b) const;
  /// Whether the triangles of either end have changed after that.
  bool has_changed_since(std::uint64_t then, std::int32_t a, std::int32_t b) const {
    return changed(a) > then || changed(b) > then;
  }

  std::int32_t vertex_end() const { return static_cast<std::int32_t>(vertices_.size()); }
  std::int32_t triangle_end() const { return static_cast<std::int32_t>(triangles_.size()); }
  std::int64_t triangle_count() const { return triangle_count_; }
  bool is_there(std::int32_t t) const { return triangle(t).nodes[0] >= 0; }

  const SurfaceVertex& vertex(std::int32_t v) const {
    return vertices_[static_cast<std::size_t>(v)];
  }
  SurfaceVertex& vertex(std::int32_t v) { return vertices_[static_cast<std::size_t>(v)]; }
  const Vec3& at(std::int32_t v) const { return places_[static_cast<std::size_t>(v)]; }
  const std::vector<Vec3>& places() const { return places_; }
  const FaceTriangle& triangle(std::int32_t t) const {
    return triangles_[static_cast<std::size_t>(t)];
  }
  std::span<const std::int32_t> ring(std::int32_t v) const {
    return rings_[static_cast<std::size_t>(v)].triangles();
  }
  const TriangleOctree& tree() const { return tree_; }

  TrianglePoints points(const Triangle& t) const { return {at(t[0]), at(t[1]), at(t[2])}; }
  Box3 box(const Triangle& t) const;

  /// The triangles that have both vertices, in the order of their numbers. Cost: O(ring).
  std::vector<std::int32_t> triangles_on(std::int32_t a, std::int32_t b) const;
  /// The same, put into `found`.
  void find_triangles_on(std::int32_t a, std::int32_t b, std::vector<std::int32_t>& found) const;
  bool has_edge(std::int32_t a, std::int32_t b) const;
  /// Whether the edge of triangle t between its vertices a and b is a feature.
  bool is_feature(std::int32_t t, std::int32_t a, std::int32_t b) const;
  /// The other ends of the feature edges of v, each once, sorted.
  std::vector<std::int32_t> feature_neighbours(std::int32_t v) const;

 private:
  void note_change(const Triangle& nodes);
  std::vector<FaceTriangle> triangles_by_vertex() const;
  void renumber_vertices(const std::vector<std::int32_t>& order);

  Box3 whole_;
  std::vector<Vec3> places_;
  std::vector<SurfaceVertex> vertices_;
  std::vector<TriangleRing> rings_;
  std::vector<std::uint64_t> changed_;
  std::vector<std::uint64_t> came_;  ///< of each triangle
  std::uint64_t now_ = 0;
  std::vector<FaceTriangle> triangles_;
  std::vector<std::int32_t> free_vertices_;
  std::vector<std::int32_t> free_triangles_;
  std::int64_t triangle_count_ = 0;
  TriangleOctree tree_;
};

/// The place of v among the triangle's nodes. @pre it is one of them.
inline std::size_t corner_of(const Triangle& t, std::int32_t v) {
  return t[0] == v ? 0 : t[1] == v ? 1 : 2;
}
inline bool has_corner(const Triangle& t, std::int32_t v) {
  return t[0] == v || t[1] == v || t[2] == v;
}
/// The third node of a triangle with a and b.
inline std::int32_t third_vertex(const Triangle& t, std::int32_t a, std::int32_t b) {
  return t[0] + t[1] + t[2] - a - b;
}
/// Whether the edge from nodes[k] is a feature.
inline bool is_feature_side(const FaceTriangle& t, std::size_t k) {
  return (t.features >> k & 1U) != 0;
}
/// The same of the edge between two of the nodes.
bool is_feature_edge(const FaceTriangle& t, std::int32_t a, std::int32_t b);
void mark_feature_edge(FaceTriangle& t, std::int32_t a, std::int32_t b);

/// What is wrong by the invariants above, the first few; empty: nothing. For tests. O(n).
std::vector<std::string> complaints_of(const ChangingSurface& surface);

}  // namespace tetfarm
