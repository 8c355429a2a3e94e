/// Whether triangles that healing would add meet those that are there.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/core/surface_mesh.h"
#include "mesh/geometry/box_tree.h"

namespace tetfarm {

/// The triangles of a surface as it is now: what is added later is not among them.
class NearTriangles {
 public:
  /// @pre the surface outlives this, and its vertices stay. Cost: O(n log n).
  explicit NearTriangles(const SurfaceMesh& surface);

  /// Whether one of `made` meets another, or a triangle of the surface that has area and is not
  /// marked in `is_gone` (empty: none is), beyond the corners and edges that both have. Exact.
  /// @pre those made have area. Cost: O(k^2 + k log n) for k made.
  bool meet(std::span<const Triangle> made, const std::vector<char>& is_gone) const;

 private:
  const std::vector<Vec3>& vertices_;
  std::vector<Triangle> triangles_;
  BoxTree tree_;
};

}  // namespace tetfarm
