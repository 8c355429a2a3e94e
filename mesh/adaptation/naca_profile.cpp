#include "mesh/adaptation/naca_profile.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "base/check.h"
#include "mesh/adaptation/point_spline.h"

namespace tetfarm {
namespace {

constexpr int samples = 1024;

double last_coefficient(bool is_sharp) { return is_sharp ? 0.1036 : 0.1015; }

/// Half the thickness at x = root².
double half_thickness(const NacaPlace& place, double root) {
  if (place.is_sharp && root == 1) return 0;
  const double x = root * root;
  const double k = last_coefficient(place.is_sharp);
  return 5 * place.thickness * root *
         (0.2969 + root * (-0.1260 + x * (-0.3516 + x * (0.2843 - k * x))));
}

/// Its derivative by the root.
double half_thickness_slope(const NacaPlace& place, double root) {
  const double x = root * root;
  const double k = last_coefficient(place.is_sharp);
  return 5 * place.thickness *
         (0.2969 + root * (-2 * 0.1260 + x * (-4 * 0.3516 + x * (6 * 0.2843 - 8 * k * x))));
}

Vec2 turned(const NacaPlace& place, double x, double y) {
  return {place.chord * (place.along.x * x - place.along.y * y),
          place.chord * (place.along.y * x + place.along.x * y)};
}

double root_of_sample(int sample) { return 2.0 * sample / samples - 1; }

}  // namespace

Vec2 direction_of_angle(double angle_deg) {
  const double quarters = angle_deg / 90;
  if (quarters == std::floor(quarters)) {
    const auto quarter = static_cast<int>(std::fmod(std::fmod(quarters, 4) + 4, 4));
    constexpr std::array<Vec2, 4> axes{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
    return axes[static_cast<std::size_t>(quarter)];
  }
  const double angle = angle_deg * std::numbers::pi / 180;
  return {std::cos(angle), std::sin(angle)};
}

NacaProfile::NacaProfile(const NacaPlace& place) : place_(place) {
  TF_CHECK(place.thickness > 0 && place.chord > 0);
  lengths_.push_back(0);
  for (int i = 1; i <= samples; ++i) {
    const Vec2 a = point_of_root(root_of_sample(i - 1));
    const Vec2 b = point_of_root(root_of_sample(i));
    lengths_.push_back(lengths_.back() + std::hypot(b.x - a.x, b.y - a.y));
  }
  samples_ = CurveSamples(*this, lengths_);
}

double NacaProfile::root_of(double parameter) const {
  if (parameter >= length()) return 1;
  const auto after = std::upper_bound(lengths_.begin() + 1, lengths_.end() - 1, parameter);
  const auto i = static_cast<std::size_t>(after - lengths_.begin()) - 1;
  const double share = (parameter - lengths_[i]) / (lengths_[i + 1] - lengths_[i]);
  return root_of_sample(static_cast<int>(i)) + share * (2.0 / samples);
}

Vec2 NacaProfile::point_of_root(double root) const {
  const double half = half_thickness(place_, std::abs(root));
  const Vec2 from_nose = turned(place_, root * root, root < 0 ? -half : half);
  return {place_.nose.x + from_nose.x, place_.nose.y + from_nose.y};
}

Vec2 NacaProfile::direction(double parameter) const {
  const double root = root_of(parameter);
  return turned(place_, 2 * root, half_thickness_slope(place_, std::abs(root)));
}

std::vector<std::shared_ptr<const TrueCurve>> naca_parts(const NacaPlace& place) {
  const auto profile = std::make_shared<const NacaProfile>(place);
  std::vector<std::shared_ptr<const TrueCurve>> parts{profile};
  if (place.is_sharp) return parts;
  auto base = std::make_shared<PointSpline>(
      std::vector<Vec2>{profile->at(profile->length()), profile->at(0)}, false);
  base->prepare_search();
  parts.push_back(base);
  return parts;
}

std::string naca_text(const NacaPlace& place) {
  std::array<char, 200> text{};
  const double angle = std::atan2(place.along.y, place.along.x) * 180 / std::numbers::pi;
  std::snprintf(text.data(), text.size(),
                "%s trailing edge, chord %.9g from (%.9g, %.9g), angle %.9g",
                place.is_sharp ? "sharp" : "blunt", place.chord, place.nose.x, place.nose.y, angle);
  return text.data();
}

}  // namespace tetfarm
