/// A curve that stays as it is while meshes on it come and go, and where on it is the nearest place
/// to a point.
///
/// Source: none; the thesis has no curves beneath its boundaries (3.3.3.4). The foot of a point is
/// the root of (P(t) - p) · P'(t), bracketed between samples; the search is regula falsi (Illinois)
/// with bisection, at most 100 steps. Cost: O(samples) a point.
#pragma once

#include <vector>

#include "mesh/geometry/predicates.h"

namespace tetfarm {

class TrueCurve {
 public:
  virtual ~TrueCurve() = default;

  /// Parameters run from 0 to this, and nearly as the length does.
  virtual double length() const = 0;
  /// Smooth all round; its parameters 0 and length() are the same place.
  virtual bool is_closed() const = 0;
  /// @pre 0 <= parameter <= length()
  virtual Vec2 at(double parameter) const = 0;
  /// The derivative, but for a positive factor.
  virtual Vec2 direction(double parameter) const = 0;
  /// The parameter of the place nearest to p.
  virtual double nearest(const Vec2& p) const = 0;

  /// The same place from 0 to length() on a closed curve; on an open one the parameter itself.
  double within(double parameter) const;
  /// From `from` to `to` along the curve, with sign; on a closed one the shorter way.
  double way(double from, double to) const;
};

/// What a search for the nearest place begins with.
class CurveSamples {
 public:
  CurveSamples() = default;
  /// @pre at least two parameters, rising from 0 to the length; between two of them the curve bends
  /// by less than a right angle
  CurveSamples(const TrueCurve& curve, std::vector<double> parameters);
  /// The parameter of the place of the curve nearest to p.
  double nearest(const TrueCurve& curve, const Vec2& p) const;

 private:
  std::vector<double> parameters_;
  std::vector<Vec2> points_;
  std::vector<double> sags_;  ///< of each piece: how far from its chord it may be
};

}  // namespace tetfarm
