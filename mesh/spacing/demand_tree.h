/// The smallest of many point demands at a position, by branch and bound over a tree of boxes.
///
/// Source: J. L. Bentley, "Multidimensional binary search trees" (1975), with the bound of a box
/// widened by what its demands grow on the way.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "mesh/core/vec3.h"
#include "mesh/spacing/surface_spacing.h"

namespace tetfarm {

class DemandTree {
 public:
  /// Cost: O(n log n).
  DemandTree(std::vector<PointDemand> demands, double growth);

  /// The least, over the demands, of spacing + growth * max(0, distance - radius - plateau), or
  /// `limit` if less: with radius 0 the demand at the point, else a lower bound of it within the
  /// radius. Remembers the winner as the first guess of the next call: ask in an order that stays
  /// near. Cost: O(log n), some 0.3 us along a curve through space.
  double lowest(const Vec3& point, double radius, double limit) const;

 private:
  struct Node {
    Box3 box;
    double least_spacing = 0;
    /// Least of spacing - growth * plateau: the demand were the cone to go on to its apex.
    double least_apex = 0;
    std::uint32_t begin = 0;
    std::uint32_t end = 0;
    /// The children are this and the next; 0 in a leaf.
    std::uint32_t children = 0;
  };
  void split(std::size_t node);
  double value(const PointDemand& demand, const Vec3& point, double radius) const;
  double bound(const Node& node, const Vec3& point, double radius) const;

  std::vector<PointDemand> demands_;
  double growth_;
  std::vector<Node> nodes_;
  mutable std::uint32_t last_winner_ = 0;
};

}  // namespace tetfarm
