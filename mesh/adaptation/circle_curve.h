/// A circle as the true curve of a boundary, and the one that fits nodes best.
///
/// Source: least squares of the distances, by Gauss and Newton from the algebraic fit (I. Kasa,
/// 1976). In octants by rational functions of the half angle's tangent: no library function whose
/// last digit varies. Cost: O(1) a point; the fit O(nodes) a step, at most 40 steps.
#pragma once

#include <optional>
#include <span>

#include "mesh/adaptation/true_curve.h"

namespace tetfarm {

struct Circle {
  Vec2 centre;
  double radius = 1;
};

class CircleCurve : public TrueCurve {
 public:
  /// @pre radius > 0
  explicit CircleCurve(const Circle& circle) : circle_(circle) {}

  double length() const override;
  bool is_closed() const override { return true; }
  Vec2 at(double parameter) const override;
  Vec2 direction(double parameter) const override;
  double nearest(const Vec2& p) const override;

 private:
  Circle circle_;
};

/// The circle of the least sum of squared distances; round numbers in place of those of the fit
/// where the nodes cannot tell them apart. Nothing where the nodes lie on a line, or are fewer than
/// three.
std::optional<Circle> fitted_circle(std::span<const Vec2> nodes);

}  // namespace tetfarm
