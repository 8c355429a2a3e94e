#include "report/svg_charts.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>

namespace tetfarm {
namespace {

using testing::HasSubstr;
using testing::Not;

/// The heights of the bars, or widths of the spans, that have a title with these words.
std::vector<double> sizes_of(const std::string& svg, const std::string& what,
                             const std::string& words) {
  const std::regex box("<rect [^>]*" + what + "=\"([0-9.]+)\"[^>]*><title>([^<]*)</title>");
  std::vector<double> sizes;
  for (std::sregex_iterator found(svg.begin(), svg.end(), box), end; found != end; ++found) {
    if ((*found)[2].str().find(words) != std::string::npos) {
      sizes.push_back(std::stod((*found)[1]));
    }
  }
  return sizes;
}

BarChart three_bars() {
  return {.title = "<b>",
          .unit = "m",
          .names = {"a", "b", "c"},
          .series = {{"one & two", "#123456", {1, 0, 100}}}};
}

TEST(SvgCharts, bars_are_as_high_as_their_values) {
  const std::string svg = svg_of(three_bars());
  const std::vector<double> small = sizes_of(svg, "height", "a: ");
  const std::vector<double> large = sizes_of(svg, "height", "c: ");
  ASSERT_EQ(small.size(), 1U);
  ASSERT_EQ(large.size(), 1U);
  EXPECT_NEAR(large[0] / small[0], 100, 1);
  EXPECT_TRUE(sizes_of(svg, "height", "b: ").empty());
}

TEST(SvgCharts, a_logarithmic_axis_shows_what_is_small) {
  BarChart chart = three_bars();
  chart.is_logarithmic = true;
  const std::string svg = svg_of(chart);
  const double small = sizes_of(svg, "height", "a: ").at(0);
  const double large = sizes_of(svg, "height", "c: ").at(0);
  EXPECT_NEAR(large / small, 3, 0.1) << "from 0.1: one decade and three";
}

TEST(SvgCharts, escape_what_they_are_given) {
  const std::string svg = svg_of(three_bars());
  EXPECT_THAT(svg, HasSubstr("&lt;b&gt;"));
  EXPECT_THAT(svg, HasSubstr("one &amp; two"));
  EXPECT_THAT(svg, Not(HasSubstr("<b>")));
}

TEST(SvgCharts, spans_lie_in_their_rows_and_last_as_long_as_they_took) {
  Timeline timeline;
  timeline.rows = {"host 1", "host 2"};
  timeline.spans = {{0, 0, 4, "#111111", "long"}, {1, 4, 5, "#222222", "short"}};
  const std::string svg = svg_of(timeline);
  EXPECT_NEAR(sizes_of(svg, "width", "long").at(0) / sizes_of(svg, "width", "short").at(0), 4,
              0.01);
  EXPECT_LT(sizes_of(svg, "y", "long").at(0), sizes_of(svg, "y", "short").at(0));
  EXPECT_THAT(svg, HasSubstr("host 2"));
}

TEST(SvgCharts, of_very_many_spans_the_longest_are_drawn_and_that_is_said) {
  Timeline timeline;
  timeline.rows = {"host 1"};
  for (int i = 0; i < 30'000; ++i) {
    timeline.spans.push_back({0, 0, 1 + i * 1e-3, "#111111", "task " + std::to_string(i) + "."});
  }
  const std::string svg = svg_of(timeline);
  EXPECT_THAT(svg, HasSubstr("the longest attempts only"));
  EXPECT_THAT(svg, HasSubstr("task 29999."));
  EXPECT_THAT(svg, Not(HasSubstr("task 17.")));
  EXPECT_THAT(svg, HasSubstr("task 10000."));
  EXPECT_THAT(svg, Not(HasSubstr("task 9999."))) << "20,000 are drawn";
}

TEST(SvgCharts, points_without_an_expectation_are_left_out) {
  PointChart chart{.title = "t", .x_name = "x", .y_name = "y"};
  chart.points = {{1, 2, "#111111", "both"}, {0, 2, "#111111", "unknown"}};
  const std::string svg = svg_of(chart);
  EXPECT_THAT(svg, HasSubstr("both"));
  EXPECT_THAT(svg, Not(HasSubstr("unknown")));
  chart.points.clear();
  EXPECT_THAT(svg_of(chart), HasSubstr("</svg>"));
}

TEST(SvgCharts, numbers_are_short) {
  EXPECT_EQ(short_number(0), "0");
  EXPECT_EQ(short_number(1234), "1234");
  EXPECT_EQ(short_number(12'345), "12.3 k");
  EXPECT_EQ(short_number(3'500'000), "3.5 M");
  EXPECT_EQ(short_number(2.1e-9), "2.1e-09");
}

}  // namespace
}  // namespace tetfarm
