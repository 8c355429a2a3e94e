/// The smallest of many point demands at a position, by branch and bound over a tree of boxes, and
/// in the cells of an octree walk by lists that shrink from cell to cell.
///
/// Source: J. L. Bentley, "Multidimensional binary search trees" (1975), with the bound of a box
/// widened by what its demands grow on the way.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "mesh/core/vec3.h"
#include "mesh/spacing/surface_spacing.h"

namespace tetfarm {

class DemandTree {
 public:
  /// Cost: O(n log n).
  DemandTree(std::vector<PointDemand> demands, double growth);

 private:
  friend class DemandsInCell;

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
  /// spacing + growth * max(0, distance - radius - plateau): with radius 0 what is demanded at the
  /// point, else a lower bound of that within the radius.
  double value(const PointDemand& demand, const Vec3& point, double radius) const;
  /// A lower bound of what the node's demands come to at the point.
  double bound(const Node& node, const Vec3& point) const;
  /// False when no demand of the node, whose box is that far away, squared, has a lesser value.
  bool may_be_less(const Node& node, double distance2, double radius, double than) const;
  /// Lowers `best` to the value of the demand, if that is less. Remembers the winner as the first
  /// guess of the next call: ask in an order that stays near.
  void lower(const PointDemand& demand, const Vec3& point, double radius, double& best) const;
  /// The same for all demands of the node. Cost: O(log n).
  void lower_below(std::uint32_t node, const Vec3& point, double radius, double& best) const;

  std::vector<PointDemand> demands_;
  double growth_;
  double shares_of_growth_;  ///< length for a unit of spacing
  std::vector<Node> nodes_;
  mutable PointDemand last_winner_;
};

/// The demands that may be the lowest somewhere in a cell of an octree walk: a selection of those
/// of the cell round it. Those near a small cell are listed one by one, what is far from a large
/// one as nodes of the tree. A list is made when a cell inside its own is entered; most cells have
/// none inside, and the list of the cell round them serves.
class DemandsInCell {
 public:
  /// @pre the tree outlives this.
  explicit DemandsInCell(const DemandTree& tree);

  /// Enters the ball round a cell inside the one entered last. Demands of `limit` and more do not
  /// matter. Cost: O(length of the list before).
  void enter(const Vec3& centre, double radius, double limit);
  void leave();

  /// The least, over the demands, of spacing + growth * max(0, distance - radius - plateau), or
  /// `limit` if less: with radius 0 the demand at the point, else a lower bound of it within the
  /// radius.
  /// @pre the ball asked for lies in the one entered last, or is it; `limit` is at most the one
  /// given there. Cost: O(length of the list), some dozens round cells of the wanted size.
  double lowest(const Vec3& point, double radius, double limit) const;

  /// The length of the list.
  std::size_t listed() const {
    return demands_.size() - lists_.back().demand + nodes_.size() - lists_.back().node;
  }

 private:
  struct Ball {
    Vec3 centre;
    double radius = 0;
    double limit = 0;
  };
  struct Starts {
    std::size_t demand = 0;
    std::size_t node = 0;
    Vec3 centre;  ///< of the ball
  };
  /// With its value at the centre of its list's ball, by which lists are sorted.
  struct ListedDemand {
    PointDemand demand;
    double at_centre = 0;
    friend bool operator<(const ListedDemand& a, const ListedDemand& b) {
      return a.at_centre < b.at_centre;
    }
  };
  struct ListedNode {
    std::uint32_t node = 0;
    double at_centre = 0;  ///< a lower bound
    friend bool operator<(const ListedNode& a, const ListedNode& b) {
      return a.at_centre < b.at_centre;
    }
  };
  double limit_in(const Ball& ball);
  void add_list(Ball ball);
  void add(const PointDemand& demand, const Ball& ball);
  void add_below(std::uint32_t number, const Ball& ball);

  const DemandTree& tree_;
  /// Lists above each other, each from its start on.
  std::vector<ListedDemand> demands_;
  std::vector<ListedNode> nodes_;
  std::vector<Starts> lists_;
  /// The cell entered last, until it has a list.
  std::optional<Ball> unlisted_;
  /// From the centre of a cell to the demands of the list round it; kept to save allocating.
  std::vector<double> away_;
};

}  // namespace tetfarm
