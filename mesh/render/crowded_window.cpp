#include "mesh/render/crowded_window.h"

#include <algorithm>
#include <vector>

#include "base/check.h"

namespace tetfarm {
namespace {

struct Stretch {
  double low = 0;
  double high = 0;
  double length() const { return high - low; }
  double middle() const { return low + length() / 2; }
};

/// From the value that `share` of all are below to that which as many are above.
Stretch middle_of(std::vector<double> values, double share) {
  const auto skipped = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size()));
  const auto low = values.begin() + skipped;
  std::nth_element(values.begin(), low, values.end());
  const double lowest = *low;
  const auto high = values.end() - 1 - skipped;
  std::nth_element(values.begin(), high, values.end());
  return {lowest, *high};
}

}  // namespace

PlaneWindow crowded_window(std::span<const Vec2> points, double shape) {
  TF_CHECK(!points.empty() && shape > 0);
  constexpr double left_out = 0.2;
  constexpr double room = 1.25;
  constexpr double nearly_all = 0.6;
  std::vector<double> x;
  std::vector<double> y;
  for (const Vec2& point : points) {
    x.push_back(point.x);
    y.push_back(point.y);
  }
  const Stretch across = middle_of(x, left_out);
  const Stretch up = middle_of(y, left_out);
  const Stretch all_across = middle_of(std::move(x), 0);
  const Stretch all_up = middle_of(std::move(y), 0);
  const double width = room * std::max(across.length(), shape * up.length());
  PlaneWindow window;
  if (!(width > 0) ||
      width >= nearly_all * std::max(all_across.length(), shape * all_up.length())) {
    return window;
  }
  window.across = width;
  window.centre = Vec2{across.middle(), up.middle()};
  return window;
}

}  // namespace tetfarm
