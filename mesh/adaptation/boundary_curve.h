/// The true curve of a piece of boundary, on which its nodes stay whatever happens to them.
///
/// Source: thesis 3.3.3.3-4, which puts new boundary nodes at the middle of their edge, off the
/// curve. Here a piece is a cubic spline through the nodes that were given, by the length of their
/// chords, natural at its ends or closed; nodes on a straight line give the line itself, bit by bit
/// where it is parallel to an axis. Cost: O(n) to make, O(log n) a point.
#pragma once

#include <vector>

#include "mesh/geometry/predicates.h"

namespace tetfarm {

class BoundaryCurve {
 public:
  /// Through `points` in their order; a closed curve goes on from the last to the first.
  /// @pre at least two points (three when closed), neighbours differ
  BoundaryCurve(std::vector<Vec2> points, bool is_closed);

  bool is_closed() const { return is_closed_; }
  /// Parameters run from 0 to this; on a closed curve both are the same place.
  double length() const { return knots_.back(); }
  /// Of the point of the constructor.
  double parameter_of(std::size_t point) const { return knots_[point]; }
  /// The parameter of the same place from 0 to the length of a closed curve; on an open one itself.
  double within(double parameter) const;
  /// Any parameter on a closed curve; clamped to the ends on an open one.
  Vec2 at(double parameter) const;
  /// How far it is from `from` to `to` along the curve, with sign; on a closed one the shorter way.
  double way(double from, double to) const;

 private:
  std::vector<Vec2> points_;  ///< the first comes again at the end of a closed curve
  std::vector<double> knots_;
  std::vector<Vec2> seconds_;  ///< second derivatives; empty on a straight line
  bool is_closed_ = false;
};

}  // namespace tetfarm
