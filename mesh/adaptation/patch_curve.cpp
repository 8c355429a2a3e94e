#include "mesh/adaptation/patch_curve.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/check.h"
#include "mesh/adaptation/point_spline.h"

namespace tetfarm {
namespace {

double distance_from(const TrueCurve& curve, const Vec2& p) {
  const Vec2 foot = curve.at(curve.nearest(p));
  return std::hypot(foot.x - p.x, foot.y - p.y);
}

Vec2 middle_of(const Vec2& a, const Vec2& b) { return {(a.x + b.x) / 2, (a.y + b.y) / 2}; }

/// The middles tell a short straight part apart from a longer one that begins and ends there.
double farthest_from(const TrueCurve& curve, const std::vector<Vec2>& points) {
  double farthest = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    farthest = std::max(farthest, distance_from(curve, points[i]));
    if (i == 0) continue;
    farthest = std::max(farthest, distance_from(curve, middle_of(points[i - 1], points[i])));
  }
  return farthest;
}

std::shared_ptr<const TrueCurve> line_between(const Vec2& a, const Vec2& b) {
  auto line = std::make_shared<PointSpline>(std::vector<Vec2>{a, b}, false);
  line->prepare_search();
  return line;
}

std::shared_ptr<const TrueCurve> nearest_part(const PatchCurve& curve,
                                              const std::vector<Vec2>& points) {
  std::shared_ptr<const TrueCurve> best;
  double least = std::numeric_limits<double>::infinity();
  for (const std::shared_ptr<const TrueCurve>& part : curve.parts) {
    const double farthest = curve.parts.size() == 1 ? 0 : farthest_from(*part, points);
    if (farthest < least) {
      least = farthest;
      best = part;
    }
  }
  TF_CHECK(best != nullptr);
  return best;
}

/// Of a node at the end of a piece, whose neighbour in it is `beside`: a place where the curve both
/// begins and ends is the one or the other.
double parameter_at_end(const TrueCurve& curve, const Vec2& end, const Vec2& beside) {
  const double parameter = curve.nearest(end);
  if (curve.is_closed()) return parameter;
  const Vec2 first = curve.at(0);
  const Vec2 last = curve.at(curve.length());
  if (!(first == last) || !(end == first)) return parameter;
  return curve.nearest(middle_of(end, beside)) < curve.length() / 2 ? 0 : curve.length();
}

}  // namespace

const PatchCurve* curve_of_patch(std::span<const PatchCurve> curves, std::int32_t patch) {
  for (const PatchCurve& curve : curves) {
    if (std::find(curve.patches.begin(), curve.patches.end(), patch) != curve.patches.end()) {
      return &curve;
    }
  }
  return nullptr;
}

PieceOnCurve piece_on_curve(const PatchCurve& curve, const std::vector<Vec2>& points,
                            bool is_closed) {
  TF_CHECK(points.size() >= (is_closed ? 3U : 2U));
  PieceOnCurve piece;
  const bool is_line = curve.parts.empty();
  if (is_line && (is_closed || points.front() == points.back())) {
    piece.fold = 0;  // a line does not come back
    return piece;
  }
  const std::shared_ptr<const TrueCurve> part =
      is_line ? line_between(points.front(), points.back()) : nearest_part(curve, points);
  const std::size_t n = points.size();
  std::vector<double> on_curve;
  on_curve.reserve(n + 1);
  for (std::size_t i = 0; i < n; ++i) {
    const bool is_end = !is_closed && (i == 0 || i + 1 == n);
    on_curve.push_back(is_end ? parameter_at_end(*part, points[i], points[i == 0 ? 1 : i - 1])
                              : part->nearest(points[i]));
  }
  if (is_closed) on_curve.push_back(on_curve.front());
  double passed = 0;
  piece.parameters.push_back(0);
  for (std::size_t i = 1; i < on_curve.size(); ++i) {
    const double way = part->way(on_curve[i - 1], on_curve[i]);
    // The second node says in which direction the piece goes.
    const bool follows = passed < 0 || (i == 1 && way < 0) ? way < 0 : way > 0;
    if (!follows && !piece.fold.has_value()) piece.fold = i % n;
    passed += way;
    if (i < n) piece.parameters.push_back(std::abs(passed));
  }
  // Once round, and no more.
  if (is_closed && !(std::abs(std::abs(passed) / part->length() - 1) < 1e-6)) {
    piece.fold = piece.fold.value_or(0);
  }
  if (is_closed) passed = passed < 0 ? -part->length() : part->length();
  piece.part = {part, on_curve.front(), passed, points.front(), points.back(), is_closed};
  return piece;
}

BoundaryCurve boundary_curve_of(const PatchCurve& curve, const std::vector<Vec2>& points,
                                bool is_closed) {
  PieceOnCurve piece = piece_on_curve(curve, points, is_closed);
  TF_CHECK(!piece.fold.has_value());
  return {std::move(piece.part), std::move(piece.parameters)};
}

}  // namespace tetfarm
