/// A piece of boundary between two corners as its nodes see it: a part of a true curve, on which
/// they stay whatever happens to them.
///
/// Source: thesis 3.3.3.3-4, which puts new boundary nodes at the middle of their edge, off the
/// curve. Cost: that of the curve, O(log n) a point.
#pragma once

#include <memory>
#include <vector>

#include "mesh/adaptation/true_curve.h"
#include "mesh/geometry/predicates.h"

namespace tetfarm {

/// Which part of a curve a piece of boundary is.
struct CurvePart {
  std::shared_ptr<const TrueCurve> curve;
  double from = 0;  ///< the curve's parameter where the part begins
  double way = 0;   ///< how far it goes from there; below 0 against the curve's own direction
  Vec2 begins, ends;
  bool is_closed = false;
};

class BoundaryCurve {
 public:
  /// The spline through `points` in their order; a closed curve goes on from the last to the first.
  /// @pre at least two points (three when closed), neighbours differ
  BoundaryCurve(std::vector<Vec2> points, bool is_closed);
  /// `parameters`: of its nodes in their order, from 0 to |way|. An open part gives `begins` and
  /// `ends` bit by bit at its ends.
  BoundaryCurve(CurvePart part, std::vector<double> parameters);

  bool is_closed() const { return is_closed_; }
  /// Parameters run from 0 to this; on a closed curve both are the same place.
  double length() const { return length_; }
  /// Of a point of the constructor.
  double parameter_of(std::size_t point) const { return parameters_[point]; }
  /// The parameter of the same place from 0 to the length of a closed curve; on an open one itself.
  double within(double parameter) const;
  /// Any parameter on a closed curve; clamped to the ends on an open one.
  Vec2 at(double parameter) const;
  /// How far it is from `from` to `to` along the curve, with sign; on a closed one the shorter way.
  double way(double from, double to) const;

 private:
  std::shared_ptr<const TrueCurve> curve_;
  std::vector<double> parameters_;
  double length_ = 0;
  bool is_closed_ = false;
  bool is_whole_ = false;  ///< parameters are those of the curve
  double from_ = 0;
  double sign_ = 1;
  Vec2 begins_, ends_;
};

}  // namespace tetfarm
