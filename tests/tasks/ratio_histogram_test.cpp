#include "tasks/ratio_histogram.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace tetfarm {
namespace {

RatioHistogram of(const std::vector<double>& ratios) {
  RatioHistogram histogram;
  for (const double ratio : ratios) histogram.add(ratio);
  return histogram;
}

std::vector<double> drawn(unsigned seed, std::size_t count) {
  std::mt19937 random(seed);
  std::lognormal_distribution<double> ratio(0, 1.5);
  std::vector<double> ratios(count);
  for (double& r : ratios) r = ratio(random);
  return ratios;
}

TEST(RatioHistogram, of_nothing_has_no_quantile) {
  EXPECT_EQ(RatioHistogram().count(), 0);
  EXPECT_FALSE(RatioHistogram().quantile(0.5).has_value());
  EXPECT_EQ(RatioHistogram().text(), "");
}

TEST(RatioHistogram, tells_quantiles_to_a_quarter_of_a_percent) {
  for (const unsigned seed : {1U, 2U, 3U}) {
    std::vector<double> ratios = drawn(seed, 999);
    const RatioHistogram histogram = of(ratios);
    std::sort(ratios.begin(), ratios.end());
    for (const double share : {0.01, 0.25, 0.5, 0.75, 0.99, 1.0}) {
      const auto place = static_cast<std::size_t>(std::ceil(share * 999)) - 1;
      EXPECT_NEAR(histogram.quantile(share).value() / ratios[place], 1, 0.0026) << share;
    }
  }
}

TEST(RatioHistogram, holds_the_bounds_of_classes_on_both_sides_of_one) {
  for (const double ratio : {0.5, 0.999, 0.995, 1.0, 1.001, 1.005, 2.0}) {
    EXPECT_NEAR(of({ratio}).quantile(1).value() / ratio, 1, 0.0026) << ratio;
  }
}

TEST(RatioHistogram, takes_what_is_beyond_its_ends_for_its_ends) {
  EXPECT_NEAR(of({0}).quantile(1).value(), 1e-3, 1e-5);
  EXPECT_NEAR(of({-7}).quantile(1).value(), 1e-3, 1e-5);
  EXPECT_NEAR(of({1e-30}).quantile(1).value(), 1e-3, 1e-5);
  EXPECT_NEAR(of({1e30}).quantile(1).value(), 1e3, 10);
}

TEST(RatioHistogram, of_several_parts_is_that_of_the_whole_in_any_order) {
  const std::vector<double> first = drawn(4, 100);
  const std::vector<double> second = drawn(5, 77);
  std::vector<double> all = first;
  all.insert(all.end(), second.begin(), second.end());
  RatioHistogram forwards = of(first);
  forwards.add(of(second));
  RatioHistogram backwards = of(second);
  backwards.add(of(first));
  EXPECT_EQ(forwards, of(all));
  EXPECT_EQ(backwards, of(all));
}

TEST(RatioHistogram, is_the_same_after_it_was_told_as_text) {
  const RatioHistogram histogram = of(drawn(6, 500));
  EXPECT_EQ(RatioHistogram::from(histogram.text()), histogram);
  EXPECT_EQ(RatioHistogram::from(""), RatioHistogram());
  EXPECT_EQ(of({1, 1, 0.999}).text(), "-1 1 0 2");
}

TEST(RatioHistogram, is_not_read_from_what_is_none) {
  for (const char* text : {"1", "1 ", "1 2 ", "1 2 3", " 1 2", "1  2", "a 1", "1 0", "1 -1",
                           "2 1 1 1", "1 1 1 1", "1386 1", "-1386 1", "1 9007199254740993"}) {
    EXPECT_FALSE(RatioHistogram::from(text).has_value()) << text;
  }
}

}  // namespace
}  // namespace tetfarm
