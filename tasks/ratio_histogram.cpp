#include "tasks/ratio_histogram.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <system_error>

#include "base/check.h"

namespace tetfarm {
namespace {

/// Class k holds ratios from step^k up to step^(k + 1).
constexpr double step = 1.005;
constexpr std::int32_t classes_each_way = 1385;  // to 1000, and to 0.001

/// 1, step, step^2 …: by multiplication alone, so that all machines have the same.
using Bounds = std::array<double, classes_each_way + 1>;

const Bounds& bounds() {
  static const Bounds known = [] {
    Bounds made{};
    made[0] = 1;
    for (std::size_t i = 1; i < made.size(); ++i) made[i] = made[i - 1] * step;
    return made;
  }();
  return known;
}

/// How many of the bounds behind 1 are at most `ratio`. @pre ratio >= 1.
std::int32_t steps_below(double ratio) {
  const auto above = std::upper_bound(bounds().begin(), bounds().end(), ratio);
  return static_cast<std::int32_t>(above - bounds().begin()) - 1;
}

std::int32_t class_of(double ratio) {
  if (ratio >= 1) return steps_below(ratio);
  if (ratio * bounds().back() <= 1) return -classes_each_way;
  return -steps_below(1 / ratio) - 1;
}

/// Between its bounds.
double ratio_of(std::int32_t number) {
  const double half = std::sqrt(step);
  if (number >= 0) return bounds()[static_cast<std::size_t>(number)] * half;
  return half / bounds()[static_cast<std::size_t>(-number)];
}

/// Takes a number and a space behind it, where there is more. Nothing where there is none.
template <class Number>
std::optional<Number> take_number(std::string_view& text) {
  Number number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc()) return {};
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  if (text.empty()) return number;
  if (!text.starts_with(' ') || text.size() == 1) return {};
  text.remove_prefix(1);
  return number;
}

}  // namespace

void RatioHistogram::add(double ratio) {
  TF_CHECK(!std::isnan(ratio));
  ++counts_[class_of(ratio)];
  ++count_;
}

void RatioHistogram::add(const RatioHistogram& other) {
  for (const auto& [number, count] : other.counts_) counts_[number] += count;
  count_ += other.count_;
}

std::optional<double> RatioHistogram::quantile(double share) const {
  TF_CHECK(share > 0 && share <= 1);
  const double wanted = share * static_cast<double>(count_);
  std::int64_t below = 0;
  for (const auto& [number, count] : counts_) {
    below += count;
    if (static_cast<double>(below) >= wanted) return ratio_of(number);
  }
  return {};
}

std::string RatioHistogram::text() const {
  std::string text;
  for (const auto& [number, count] : counts_) {
    if (!text.empty()) text += ' ';
    text += std::to_string(number) + ' ' + std::to_string(count);
  }
  return text;
}

std::optional<RatioHistogram> RatioHistogram::from(std::string_view text) {
  constexpr std::int64_t most = std::int64_t{1} << 53;
  RatioHistogram histogram;
  std::int32_t last = std::numeric_limits<std::int32_t>::min();
  while (!text.empty()) {
    const auto number = take_number<std::int32_t>(text);
    if (!number || *number <= last || *number < -classes_each_way || *number > classes_each_way) {
      return {};
    }
    const auto count = take_number<std::int64_t>(text);
    if (!count || *count <= 0 || *count > most) return {};
    histogram.counts_[*number] = *count;
    histogram.count_ += *count;
    last = *number;
  }
  return histogram;
}

}  // namespace tetfarm
