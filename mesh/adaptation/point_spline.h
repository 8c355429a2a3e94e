/// The cubic spline through points, by the length of their chords: natural at its ends, or closed.
///
/// Points on a straight line give the line itself, bit by bit where it is parallel to an axis.
/// Source: the classical one (C. de Boor, "A Practical Guide to Splines", 1978). Cost: O(n) to
/// make, O(log n) a point, O(n) for the place nearest to a point.
#pragma once

#include <memory>
#include <vector>

#include "mesh/adaptation/true_curve.h"

namespace tetfarm {

class PointSpline : public TrueCurve {
 public:
  /// Through `points` in their order; a closed curve goes on from the last to the first.
  /// @pre at least two points (three when closed), neighbours differ
  PointSpline(std::vector<Vec2> points, bool is_closed);

  double length() const override { return knots_.back(); }
  bool is_closed() const override { return is_closed_; }
  Vec2 at(double parameter) const override;
  Vec2 direction(double parameter) const override;
  /// @pre prepare_search()
  double nearest(const Vec2& p) const override;

  /// The parameters of the points; of a closed curve's first point at the end once more.
  const std::vector<double>& knots() const { return knots_; }
  /// Makes what nearest() needs; few splines do.
  void prepare_search();

 private:
  std::size_t span_of(double parameter) const;

  std::vector<Vec2> points_;  ///< the first comes again at the end of a closed curve
  std::vector<double> knots_;
  std::vector<Vec2> seconds_;  ///< second derivatives; empty on a straight line
  bool is_closed_ = false;
  CurveSamples samples_;
};

/// A closed loop of points as splines between the points at which it turns by more than the angle,
/// in order; one closed spline where there are none. @pre at least three points, neighbours differ
std::vector<std::shared_ptr<const TrueCurve>> splines_of_loop(const std::vector<Vec2>& loop,
                                                              double corner_angle_deg);

}  // namespace tetfarm
