#include "mesh/adaptation/point_spline.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "base/check.h"
#include "mesh/adaptation/curve_tracing.h"

namespace tetfarm {
namespace {

constexpr int samples_between_points = 4;

Vec2 operator+(const Vec2& a, const Vec2& b) { return {a.x + b.x, a.y + b.y}; }
Vec2 operator-(const Vec2& a, const Vec2& b) { return {a.x - b.x, a.y - b.y}; }
Vec2 operator*(double s, const Vec2& a) { return {s * a.x, s * a.y}; }

/// Within rounding of the chord from the first to the last point, and forward along it.
bool is_straight(const std::vector<Vec2>& points) {
  const Vec2 chord = points.back() - points.front();
  const double squared = chord.x * chord.x + chord.y * chord.y;
  if (!(squared > 0)) return false;  // a loop that begins and ends at one corner
  double before = 0;
  for (const Vec2& p : points) {
    const Vec2 from = p - points.front();
    const double across = (chord.x * from.y - chord.y * from.x) / squared;
    const double along = (chord.x * from.x + chord.y * from.y) / squared;
    if (std::abs(across) > 1e-14 || along < before) return false;
    before = along;
  }
  return true;
}

/// A row of the tridiagonal system of the second derivatives.
struct Row {
  double lower = 0, diagonal = 1, upper = 0;
  Vec2 right;
};

Row row_at(const std::vector<double>& h, const std::vector<Vec2>& slopes, std::size_t before,
           std::size_t after) {
  return {h[before], 2 * (h[before] + h[after]), h[after], 6.0 * (slopes[after] - slopes[before])};
}

/// Thomas's algorithm. @pre diagonally dominant
std::vector<Vec2> solve(std::vector<Row> rows) {
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const double share = rows[i].lower / rows[i - 1].diagonal;
    rows[i].diagonal -= share * rows[i - 1].upper;
    rows[i].right = rows[i].right - share * rows[i - 1].right;
  }
  std::vector<Vec2> x(rows.size());
  for (std::size_t i = rows.size(); i-- > 0;) {
    const Vec2 above = i + 1 < rows.size() ? rows[i].upper * x[i + 1] : Vec2{};
    x[i] = (1 / rows[i].diagonal) * (rows[i].right - above);
  }
  return x;
}

/// Of a closed curve of n pieces: the cyclic system by Sherman and Morrison.
std::vector<Vec2> cyclic_seconds(const std::vector<double>& h, const std::vector<Vec2>& slopes) {
  const std::size_t n = h.size();
  std::vector<Row> rows(n);
  for (std::size_t i = 0; i < n; ++i) rows[i] = row_at(h, slopes, (i + n - 1) % n, i);
  const double corner = h[n - 1];
  const double gamma = -rows[0].diagonal;
  rows[0].diagonal -= gamma;
  rows[n - 1].diagonal -= corner * corner / gamma;
  std::vector<Row> turned = rows;
  for (Row& row : turned) row.right = {};
  turned[0].right = {gamma, 0};
  turned[n - 1].right = {corner, 0};
  std::vector<Vec2> x = solve(rows);
  const std::vector<Vec2> z = solve(turned);
  const double under = 1 + z[0].x + corner * z[n - 1].x / gamma;
  const Vec2 over = (1 / under) * (x[0] + (corner / gamma) * x[n - 1]);
  for (std::size_t i = 0; i < n; ++i) x[i] = x[i] - z[i].x * over;
  x.push_back(x.front());
  return x;
}

std::vector<Vec2> natural_seconds(const std::vector<double>& h, const std::vector<Vec2>& slopes) {
  std::vector<Row> rows(h.size() + 1);
  for (std::size_t i = 1; i < h.size(); ++i) rows[i] = row_at(h, slopes, i - 1, i);
  return solve(rows);
}

}  // namespace

PointSpline::PointSpline(std::vector<Vec2> points, bool is_closed)
    : points_(std::move(points)), is_closed_(is_closed) {
  TF_CHECK(points_.size() >= (is_closed ? 3U : 2U));
  if (is_closed) points_.push_back(points_.front());
  std::vector<double> lengths;
  std::vector<Vec2> slopes;
  knots_.push_back(0);
  for (std::size_t i = 0; i + 1 < points_.size(); ++i) {
    const Vec2 chord = points_[i + 1] - points_[i];
    lengths.push_back(std::hypot(chord.x, chord.y));
    TF_CHECK(lengths.back() > 0);
    slopes.push_back((1 / lengths.back()) * chord);
    knots_.push_back(knots_.back() + lengths.back());
  }
  if (is_closed) {
    seconds_ = cyclic_seconds(lengths, slopes);
  } else if (is_straight(points_)) {
    points_ = {points_.front(), points_.back()};
  } else {
    seconds_ = natural_seconds(lengths, slopes);
  }
}

Vec2 PointSpline::at(double parameter) const {
  if (seconds_.empty()) {
    const double share = parameter / length();
    if (share == 1) return points_.back();
    return points_.front() + share * (points_.back() - points_.front());
  }
  const std::size_t i = span_of(parameter);
  const double h = knots_[i + 1] - knots_[i];
  const double b = (parameter - knots_[i]) / h;
  const double a = 1 - b;
  // From the nearer end, so that a knot gives its point bit by bit.
  const Vec2 bend =
      (h * h / 6) * ((a * a * a - a) * seconds_[i] + (b * b * b - b) * seconds_[i + 1]);
  const Vec2 chord = points_[i + 1] - points_[i];
  return (b <= 0.5 ? points_[i] + b * chord : points_[i + 1] - a * chord) + bend;
}

Vec2 PointSpline::direction(double parameter) const {
  if (seconds_.empty()) return points_.back() - points_.front();
  const std::size_t i = span_of(parameter);
  const double h = knots_[i + 1] - knots_[i];
  const double b = (parameter - knots_[i]) / h;
  const double a = 1 - b;
  const Vec2 bend = (h / 6) * ((1 - 3 * a * a) * seconds_[i] + (3 * b * b - 1) * seconds_[i + 1]);
  return (1 / h) * (points_[i + 1] - points_[i]) + bend;
}

double PointSpline::nearest(const Vec2& p) const { return samples_.nearest(*this, p); }

void PointSpline::prepare_search() {
  std::vector<double> parameters;
  if (seconds_.empty()) {
    parameters = {0, length()};
  } else {
    for (std::size_t i = 0; i + 1 < knots_.size(); ++i) {
      for (int part = 0; part < samples_between_points; ++part) {
        const double share = static_cast<double>(part) / samples_between_points;
        parameters.push_back(knots_[i] + share * (knots_[i + 1] - knots_[i]));
      }
    }
    parameters.push_back(knots_.back());
  }
  samples_ = CurveSamples(*this, std::move(parameters));
}

std::size_t PointSpline::span_of(double parameter) const {
  const auto after = std::upper_bound(knots_.begin() + 1, knots_.end() - 1, parameter);
  return static_cast<std::size_t>(after - knots_.begin()) - 1;
}

std::vector<std::shared_ptr<const TrueCurve>> splines_of_loop(const std::vector<Vec2>& loop,
                                                              double corner_angle_deg) {
  const std::size_t n = loop.size();
  const double cosine = std::cos(corner_angle_deg * std::numbers::pi / 180);
  std::vector<std::size_t> corners;
  for (std::size_t i = 0; i < n; ++i) {
    if (turns_by_more(loop[(i + n - 1) % n], loop[i], loop[(i + 1) % n], cosine)) {
      corners.push_back(i);
    }
  }
  std::vector<std::shared_ptr<const TrueCurve>> splines;
  const auto add = [&](std::vector<Vec2> points, bool is_closed) {
    auto spline = std::make_shared<PointSpline>(std::move(points), is_closed);
    spline->prepare_search();
    splines.push_back(std::move(spline));
  };
  if (corners.empty()) add(loop, true);
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const std::size_t last = k + 1 < corners.size() ? corners[k + 1] : corners.front() + n;
    std::vector<Vec2> points;
    for (std::size_t i = corners[k]; i <= last; ++i) points.push_back(loop[i % n]);
    add(std::move(points), false);
  }
  return splines;
}

}  // namespace tetfarm
