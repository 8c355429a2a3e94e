/// A surface under construction: vertices, triangles, the patch that is being filled, and strips of
/// triangles between two rows of vertices.
///
/// A shape is closed because its parts share vertices by number; nothing is welded.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "mesh/core/surface_mesh.h"

namespace tetfarm {

/// Vertices in the order in which they lie along a line.
using VertexRow = std::vector<std::int32_t>;

class PatchedSurface {
 public:
  /// What is added from here on belongs to a new patch.
  void begin_patch(const std::string& name);
  std::int32_t add_vertex(const Vec3& p);
  /// @pre a patch was begun.
  void add_triangle(std::int32_t a, std::int32_t b, std::int32_t c);
  /// All of a surface, as it is or with each triangle turned over.
  void add_surface(const SurfaceMesh& surface, bool turned);
  /// Joins two rows that run alongside by triangles, the shorter diagonal first. They are
  /// anticlockwise where `right` lies to the right of the way along `left`. Either may be one
  /// vertex. Cost: O(n).
  void zip(const VertexRow& left, const VertexRow& right);
  /// As zip, for rows that close on themselves; their first vertices lie beside each other.
  void zip_rings(VertexRow left, VertexRow right);

  const Vec3& at(std::int32_t v) const { return mesh_.vertices[static_cast<std::size_t>(v)]; }
  SurfaceMesh take() { return std::move(mesh_); }

 private:
  SurfaceMesh mesh_;
};

/// How many parts of about `spacing` a length has; at least `least`.
/// @param option what the spacing was typed as.
/// @throws UsageError when they would be more than 20 000.
int parts_of_length(double length, double spacing, int least,
                    const std::string& option = "--spacing");

}  // namespace tetfarm
