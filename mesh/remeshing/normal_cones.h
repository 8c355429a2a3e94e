/// Whether all of a surface near a place looks much the same way.
///
/// Source: P. Volino and N. Magnenat-Thalmann, "Efficient self-collision detection on smoothly
/// discretized surface animations using geometrical shape regularity" (1994): a part of a surface
/// whose normals lie in a cone does not come back on itself, so that nothing in it need be looked
/// at one by one. Here a tree of boxes, split at the median of their centres along the longest
/// axis, each with the cone of the normals of what is in it.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/core/surface_mesh.h"

namespace tetfarm {

class NormalCones {
 public:
  NormalCones() = default;
  /// @param normals of the triangles, of unit length; one that is zero says nothing and is passed
  /// over. Cost: O(n log n), 55 to 110 bytes a triangle.
  NormalCones(const SurfaceMesh& surface, std::span<const Vec3> normals);

  /// Whether each triangle that comes into the box has a normal whose cosine with `way`, of unit
  /// length, is above `least_cosine` (from 0 to 1). May be false where one passes by the box
  /// closely. @pre surface and normals are those that this was made of. Cost: O(log n) where the
  /// surface is smooth.
  bool all_look(const SurfaceMesh& surface, std::span<const Vec3> normals, const Box3& box,
                const Vec3& way, double least_cosine) const;

 private:
  static constexpr std::size_t most_depth = 64;
  /// A leaf has count > 0 and items [first, first + count); otherwise the children are this + 1 and
  /// `right`.
  struct Node {
    Box3 box;
    Vec3 axis;  ///< zero: the normals lie in no cone
    double cosine = 0;
    double sine = 0;
    std::int32_t first = 0;
    std::int32_t count = 0;
    std::int32_t right = 0;
  };
  void build(std::span<const Box3> boxes, std::span<const Vec3> normals, std::int32_t first,
             std::int32_t last);
  void set_cone(Node& node, std::span<const Vec3> normals, std::int32_t first,
                std::int32_t last) const;
  static bool cone_looks(const Node& node, const Vec3& way, double least_cosine);

  std::vector<Node> nodes_;
  std::vector<std::int32_t> items_;
};

}  // namespace tetfarm
