#include "mesh/shapes/wing_section.h"

#include <cmath>
#include <cstddef>

#include "base/check.h"
#include "mesh/shapes/circle_point.h"

namespace tetfarm {
namespace {

constexpr int points_of_half = 4000;
constexpr int points_of_fan = 400;
constexpr double thickness = 0.12;

double height(double x) {
  return 5 * thickness *
         (0.2969 * std::sqrt(x) + x * (-0.1260 + x * (-0.3516 + x * (0.2843 + x * -0.1036))));
}

double slope(double x) {
  return 5 * thickness *
         (0.14845 / std::sqrt(x) - 0.1260 + x * (-0.7032 + x * (0.8529 + x * -0.4144)));
}

}  // namespace

std::vector<SectionPoint> upper_half() {
  std::vector<SectionPoint> half;
  const Vec3 behind{1, 0, 0};
  const Vec3 side = normalized({-slope(1), 0, 1});
  for (int i = 0; i <= points_of_fan; ++i) {
    const double t = static_cast<double>(i) / points_of_fan;
    half.push_back({{1, 0, 0}, normalized((1 - t) * behind + t * side)});
  }
  for (int i = 1; i < points_of_half; ++i) {
    const double x = 0.5 * (1 + circle_point(i, 2 * points_of_half).cosine);
    half.push_back({{x, 0, height(x)}, normalized({-slope(x), 0, 1})});
  }
  half.push_back({{0, 0, 0}, {-1, 0, 0}});
  return half;
}

std::vector<Vec3> upper_line(const std::vector<SectionPoint>& half, const Ring& ring) {
  const Vec3 middle{0.5, 0, 0};
  std::vector<Vec3> line;
  line.reserve(half.size());
  for (const SectionPoint& p : half) {
    line.push_back(ring.shrink * (p.at - middle) + ring.reach * p.normal);
  }
  return line;
}

double length_of(const std::vector<Vec3>& line) {
  double length = 0;
  for (std::size_t i = 1; i < line.size(); ++i) length += distance(line[i - 1], line[i]);
  return length;
}

std::vector<Vec3> even_points(const std::vector<Vec3>& line, int parts) {
  TF_CHECK(!line.empty() && parts > 0);
  const double step = length_of(line) / parts;
  std::vector<Vec3> points = {line.front()};
  double passed = 0;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const double piece = distance(line[i - 1], line[i]);
    while (static_cast<int>(points.size()) < parts &&
           static_cast<double>(points.size()) * step <= passed + piece && piece > 0) {
      const double t = (static_cast<double>(points.size()) * step - passed) / piece;
      points.push_back((1 - t) * line[i - 1] + t * line[i]);
    }
    passed += piece;
  }
  points.push_back(line.back());
  return points;
}

}  // namespace tetfarm
