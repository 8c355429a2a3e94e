#include "report/line_chart.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>
#include <sstream>

#include "base/error.h"

namespace tetfarm {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

LineChart two_points() {
  LineChart chart;
  chart.x_name = "x";
  chart.curves = {{"cp & more", "#123456", {{{0, -1}, {1, 3}}}}};
  return chart;
}

/// Of the first curve.
std::vector<Vec2> places(const std::string& svg) {
  std::smatch found;
  EXPECT_TRUE(std::regex_search(svg, found, std::regex("points=\"([^\"]*)\"")));
  std::istringstream words(found[1].str());
  std::vector<Vec2> places;
  char comma = 0;
  for (Vec2 p; words >> p.x >> comma >> p.y;) places.push_back(p);
  return places;
}

TEST(LineChart, has_larger_values_higher_unless_it_is_reversed) {
  LineChart chart = two_points();
  const std::vector<Vec2> plain = places(svg_file_of(chart));
  ASSERT_EQ(plain.size(), 2U);
  EXPECT_LT(plain[0].x, plain[1].x);
  EXPECT_GT(plain[0].y, plain[1].y);
  chart.is_reversed = true;
  EXPECT_LT(places(svg_file_of(chart))[0].y, places(svg_file_of(chart))[1].y);
}

TEST(LineChart, is_a_file_of_its_own_with_numbers_along_both_axes) {
  const std::string svg = svg_file_of(two_points());
  EXPECT_THAT(svg, HasSubstr("<svg xmlns=\"http://www.w3.org/2000/svg\""));
  EXPECT_THAT(svg, HasSubstr(">0.5</text>"));
  EXPECT_THAT(svg, HasSubstr(">-1.0</text>"));
  EXPECT_THAT(svg, HasSubstr("cp &amp; more"));
  EXPECT_THAT(svg, Not(HasSubstr("cp & more")));
  EXPECT_EQ(svg_file_of(two_points()), svg);
}

TEST(LineChart, draws_values_that_are_all_the_same) {
  LineChart chart = two_points();
  chart.curves[0].pieces = {{{2, 5}, {2, 5}}};
  for (const Vec2& p : places(svg_file_of(chart))) {
    EXPECT_GT(p.x, 0);
    EXPECT_LT(p.x, 800);
    EXPECT_GT(p.y, 0);
    EXPECT_LT(p.y, 500);
  }
  chart.curves[0].pieces = {{{0, -1.7e308}, {1, 1.7e308}}};
  EXPECT_THROW(svg_file_of(chart), UsageError);
}

}  // namespace
}  // namespace tetfarm
