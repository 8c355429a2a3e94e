/// Counts of numbers in bins of one width.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

namespace tetfarm {

struct Histogram {
  Histogram(double low_end, double high_end, std::size_t bins)
      : low(low_end), high(high_end), counts(bins) {}

  /// What lies outside counts in the first or in the last bin.
  void add(double value) {
    const double place = (value - low) / (high - low) * static_cast<double>(counts.size());
    const double last = static_cast<double>(counts.size()) - 1;
    ++counts[static_cast<std::size_t>(std::clamp(place, 0.0, last))];
  }
  double end_of(std::size_t bins) const {
    return low + (high - low) * static_cast<double>(bins) / static_cast<double>(counts.size());
  }

  double low = 0;
  double high = 1;
  std::vector<std::int64_t> counts;
};

}  // namespace tetfarm
