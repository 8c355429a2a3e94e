#include "mesh/adaptation/boundary_curve.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/check.h"
#include "mesh/adaptation/point_spline.h"

namespace tetfarm {

BoundaryCurve::BoundaryCurve(std::vector<Vec2> points, bool is_closed)
    : is_closed_(is_closed), is_whole_(true) {
  const auto spline = std::make_shared<const PointSpline>(std::move(points), is_closed);
  parameters_ = spline->knots();
  length_ = spline->length();
  curve_ = spline;
}

BoundaryCurve::BoundaryCurve(CurvePart part, std::vector<double> parameters)
    : curve_(std::move(part.curve)),
      parameters_(std::move(parameters)),
      length_(std::abs(part.way)),
      is_closed_(part.is_closed),
      from_(part.from),
      sign_(part.way < 0 ? -1 : 1),
      begins_(part.begins),
      ends_(part.ends) {
  TF_CHECK(curve_ != nullptr && length_ > 0);
}

double BoundaryCurve::within(double parameter) const {
  if (!is_closed_) return parameter;
  parameter = std::fmod(parameter, length());
  return parameter < 0 ? parameter + length() : parameter;
}

Vec2 BoundaryCurve::at(double parameter) const {
  parameter = std::clamp(within(parameter), 0.0, length());
  if (is_whole_) return curve_->at(parameter);
  if (!is_closed_ && parameter == 0) return begins_;
  if (!is_closed_ && parameter == length()) return ends_;
  const double on_curve = curve_->within(from_ + sign_ * parameter);
  return curve_->at(std::clamp(on_curve, 0.0, curve_->length()));
}

double BoundaryCurve::way(double from, double to) const {
  const double way = to - from;
  return is_closed_ ? std::remainder(way, length()) : way;
}

}  // namespace tetfarm
