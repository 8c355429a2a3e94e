#include "base/angle_text.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "base/check.h"

namespace tetfarm {
namespace {

constexpr int most_decimals = 9;
constexpr int digits_of_difference = 2;

}  // namespace

std::string angle_text(double deg, int decimals) {
  TF_CHECK(decimals >= 0 && decimals <= most_decimals);
  if (deg == 0) return "0";
  if (deg == 180) return "180";
  const double to_flat = std::min(deg, 180 - deg);
  if (to_flat > 0 && to_flat < 1) {
    const int zeros = static_cast<int>(std::floor(-std::log10(to_flat)));
    decimals = std::clamp(digits_of_difference + zeros, decimals, most_decimals);
  }
  char text[40];
  std::snprintf(text, sizeof text, "%.*f", decimals, deg);
  return text;
}

}  // namespace tetfarm
