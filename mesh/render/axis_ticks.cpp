#include "mesh/render/axis_ticks.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdio>

#include "base/check.h"

namespace tetfarm {
namespace {

/// number · 10^exponent, rounded once.
double decimal(std::int64_t number, int exponent) {
  const std::string text = std::to_string(number) + "e" + std::to_string(exponent);
  double value = 0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

struct Step {
  std::int64_t factor = 1;  // 1, 2 or 5
  int exponent = 0;
  double size() const { return decimal(factor, exponent); }
};

/// Multiples of the step from low to high; the ends count where they are missed by rounding.
struct Multiples {
  double first = 0;
  double last = -1;
  double count() const { return last - first + 1; }
};
Multiples multiples_of(double step, double low, double high) {
  constexpr double rounding = 1e-9;
  return {std::ceil(low / step - rounding), std::floor(high / step + rounding)};
}

Step step_of(double low, double high, int most) {
  Step step{1, static_cast<int>(std::floor(std::log10(high - low))) - 3};
  while (multiples_of(step.size(), low, high).count() > most) {
    step = step.factor == 5   ? Step{1, step.exponent + 1}
           : step.factor == 2 ? Step{5, step.exponent}
                              : Step{2, step.exponent};
  }
  return step;
}

/// "12.50" of 1250 with exponent -2.
std::string plain(std::int64_t number, int exponent) {
  std::string digits = std::to_string(std::abs(number));
  if (exponent > 0) digits.append(static_cast<std::size_t>(exponent), '0');
  if (exponent < 0) {
    const auto decimals = static_cast<std::size_t>(-exponent);
    if (digits.size() <= decimals) digits.insert(0, decimals + 1 - digits.size(), '0');
    digits.insert(digits.size() - decimals, ".");
  }
  return (number < 0 ? "-" : "") + digits;
}

/// "1.25e4" of 1250 with exponent 1.
std::string scientific(std::int64_t number, int exponent) {
  while (number % 10 == 0) {
    number /= 10;
    ++exponent;
  }
  const int digits = static_cast<int>(std::to_string(std::abs(number)).size());
  return plain(number, 1 - digits) + "e" + std::to_string(exponent + digits - 1);
}

std::string rounded(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.6g", value);
  return text.data();
}

}  // namespace

std::vector<AxisTick> axis_ticks(double low, double high, int most) {
  TF_CHECK(std::isfinite(low) && std::isfinite(high) && low <= high && most > 0);
  const double largest = std::max(std::fabs(low), std::fabs(high));
  if (!(high - low > 1e-12 * largest) || !(largest > 1e-290)) return {{low, rounded(low)}};
  const Step step = step_of(low, high, most);
  const Multiples multiples = multiples_of(step.size(), low, high);
  const bool is_plain = step.exponent >= -5 && largest < 1e6;
  std::vector<AxisTick> ticks;
  for (double k = multiples.first; k <= multiples.last; ++k) {
    const std::int64_t number = static_cast<std::int64_t>(k) * step.factor;
    AxisTick tick{decimal(number, step.exponent), "0"};
    if (number != 0) {
      tick.text = is_plain ? plain(number, step.exponent) : scientific(number, step.exponent);
    }
    ticks.push_back(tick);
  }
  return ticks;
}

}  // namespace tetfarm
