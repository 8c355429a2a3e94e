/// What triangles ask for at a position: a spacing at them, which grows with the distance from
/// them. A patch of the surface is a source in this way.
///
/// Source: none in the thesis, whose triangle sources are few and typed by hand. Exact distances to
/// the triangles, by branch and bound over a tree of boxes as in demand_tree.h.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "mesh/core/vec3.h"
#include "mesh/spacing/spacing_field.h"
#include "mesh/spacing/surface_spacing.h"

namespace tetfarm {

/// Of `spacing` within so many times of it, as of what the surface itself asks for.
inline constexpr double triangle_plateau = surface_plateau;

/// @throws InvalidInput when a spacing or growth is not positive, or a corner not finite.
void check_triangle_demands(const std::vector<TriangleDemand>& demands);

class TriangleDemandTree {
 public:
  TriangleDemandTree() = default;
  /// @pre check_triangle_demands passed. Cost: O(n log n).
  explicit TriangleDemandTree(std::vector<TriangleDemand> demands);

  bool empty() const { return demands_.empty(); }
  std::size_t size() const { return demands_.size(); }

  /// The least, over the triangles, of spacing + growth * max(0, distance - radius - plateau), or
  /// `limit` if less: with radius 0 what is asked for at the point, else a lower bound of that
  /// within the radius. The same whatever was asked before.
  /// Cost: O(log n), but O(n) where all are equally far away; none where `limit` is less.
  double lowest(const Vec3& point, double radius, double limit) const;

  /// How many boxes and triangles have been looked at.
  std::uint64_t looked_at() const { return looked_at_; }

 private:
  struct Node {
    Box3 box;
    double least_spacing = 0;
    double least_growth = 0;
    double most_spacing = 0;
    std::uint32_t begin = 0;
    std::uint32_t end = 0;
    /// The children are this and the next; 0 in a leaf.
    std::uint32_t children = 0;
  };
  void split(std::size_t node);
  /// A lower bound of what the node's triangles ask for.
  double bound(const Node& node, const Vec3& point, double radius) const;
  void lower(std::uint32_t demand, const Vec3& point, double radius, double& best) const;

  std::vector<TriangleDemand> demands_;
  std::vector<Node> nodes_;
  mutable std::uint32_t last_winner_ = 0;  ///< the first guess of the next call
  mutable std::uint64_t looked_at_ = 0;
};

}  // namespace tetfarm
