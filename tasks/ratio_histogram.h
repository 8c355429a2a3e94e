/// How often which ratios were found, in few numbers: tasks tell theirs, and what all have found
/// adds up to the same in any order. A median or a percentile of it is right to a quarter of a
/// percent.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace tetfarm {

class RatioHistogram {
 public:
  /// Ratios beyond 0.001 and 1000 count as these. @pre not NaN.
  void add(double ratio);
  /// All of the other's.
  void add(const RatioHistogram& other);

  std::int64_t count() const { return count_; }
  /// The ratio that the share of all is not above: 0.5 for the median. Nothing of nothing.
  /// @pre 0 < share <= 1. Cost: O(1), some hundred steps.
  std::optional<double> quantile(double share) const;

  /// "CLASS COUNT CLASS COUNT …", by rising class.
  std::string text() const;
  /// Nothing where the text is none of text().
  static std::optional<RatioHistogram> from(std::string_view text);

  friend bool operator==(const RatioHistogram&, const RatioHistogram&) = default;

 private:
  std::map<std::int32_t, std::int64_t> counts_;  ///< by class
  std::int64_t count_ = 0;
};

}  // namespace tetfarm
