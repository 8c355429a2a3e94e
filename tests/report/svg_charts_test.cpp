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

TEST(SvgCharts, of_bars_stand_side_by_side_over_their_names_and_an_axis) {
  const BarChart chart{.title = "T",
                       .unit = "u",
                       .names = {"a", "b"},
                       .series = {{"s", "#111111", {1, 2}}, {"", "#222222", {0, 0.5}}}};
  const auto mark = [](const std::string& y, const std::string& text_y, const std::string& what) {
    return "<line class=\"grid\" x1=\"62.0\" y1=\"" + y + "\" x2=\"482.0\" y2=\"" + y +
           "\"/><text x=\"57.0\" y=\"" + text_y + "\" text-anchor=\"end\">" + what + "</text>";
  };
  const auto bar = [](const std::string& place, const std::string& colour,
                      const std::string& what) {
    return "<rect " + place + " fill=\"" + colour + "\"><title>" + what + "</title></rect>";
  };
  EXPECT_EQ(
      svg_of(chart),
      "<svg viewBox=\"0 0 490 240\" role=\"img\"><text class=\"title\" x=\"62\" "
      "y=\"15\">T</text>"
      "<text x=\"475.2\" y=\"15.0\" text-anchor=\"start\">s</text>" +
          bar("x=\"461.20\" y=\"6.00\" width=\"10.00\" height=\"10.00\"", "#111111", "s") +
          mark("200.0", "204.0", "0") + mark("156.5", "160.5", "0.5") +
          mark("113.0", "117.0", "1") + mark("69.5", "73.5", "1.5") + mark("26.0", "30.0", "2") +
          bar("x=\"76.70\" y=\"113.00\" width=\"90.30\" height=\"87.00\"", "#111111", "a: 1 s") +
          bar("x=\"286.70\" y=\"26.00\" width=\"90.30\" height=\"174.00\"", "#111111", "b: 2 s") +
          bar("x=\"377.00\" y=\"156.50\" width=\"90.30\" height=\"43.50\"", "#222222", "b: 0.5 ") +
          "<line class=\"axis\" x1=\"62.0\" y1=\"200.0\" x2=\"482.0\" y2=\"200.0\"/>"
          "<text x=\"167.0\" y=\"215.0\" text-anchor=\"middle\">a</text>"
          "<text x=\"377.0\" y=\"215.0\" text-anchor=\"middle\">b</text>"
          "<text x=\"272.0\" y=\"234.0\" text-anchor=\"middle\">u</text></svg>");
}

TEST(SvgCharts, that_are_wide_are_over_the_whole_page_and_have_room_for_more_names) {
  BarChart chart{.title = "T", .is_wide = false};
  for (int i = 0; i < 20; ++i) {
    chart.names.push_back("n" + std::to_string(i) + ".");
  }
  chart.series = {{"", "#111111", std::vector<double>(20, 0.0)}};
  const auto names_of = [&chart] {
    const std::string svg = svg_of(chart);
    std::string names;
    for (const std::string& name : chart.names) {
      if (svg.find(">" + name + "<") != std::string::npos) names += name;
    }
    return names;
  };
  EXPECT_EQ(names_of(), "n0.n3.n6.n9.n12.n15.n18.") << "21 a bar, 58 a name";
  chart.is_wide = true;
  EXPECT_EQ(names_of(), "n0.n2.n4.n6.n8.n10.n12.n14.n16.n18.");
  EXPECT_THAT(svg_of(chart), HasSubstr("viewBox=\"0 0 1000 230\""));
}

TEST(SvgCharts, of_spans_have_rows_seconds_and_what_was_done) {
  Timeline timeline;
  timeline.rows = {"host 1", "host 2"};
  timeline.spans = {{0, 0, 4, "#111111", "long"}, {1, 4, 5, "#222222", "short"}};
  const auto mark = [](const std::string& x, const std::string& what) {
    return "<line class=\"grid\" x1=\"" + x + "\" y1=\"26.0\" x2=\"" + x +
           "\" y2=\"68.0\"/><text x=\"" + x + "\" y=\"82.0\" text-anchor=\"middle\">" + what +
           "</text>";
  };
  EXPECT_EQ(svg_of(timeline),
            "<svg viewBox=\"0 0 1000 102\" role=\"img\"><text class=\"title\" x=\"62\" "
            "y=\"15\"></text>" +
                mark("130.0", "0") + mark("302.4", "1") + mark("474.8", "2") + mark("647.2", "3") +
                mark("819.6", "4") + mark("992.0", "5") +
                "<text x=\"565.0\" y=\"97.0\" text-anchor=\"middle\">seconds since the first "
                "attempt</text>"
                "<text x=\"124.0\" y=\"40.0\" text-anchor=\"end\">host 1</text>"
                "<text x=\"124.0\" y=\"60.0\" text-anchor=\"end\">host 2</text>"
                "<rect x=\"130.00\" y=\"28.00\" width=\"689.60\" height=\"16.00\" "
                "fill=\"#111111\"><title>long</title></rect>"
                "<rect x=\"819.60\" y=\"48.00\" width=\"172.40\" height=\"16.00\" "
                "fill=\"#222222\"><title>short</title></rect></svg>");
}

TEST(SvgCharts, of_spans_in_many_rows_have_low_rows_without_names) {
  Timeline timeline;
  for (int i = 0; i < 100; ++i) timeline.rows.push_back("host " + std::to_string(i));
  timeline.spans = {{99, 0, 1e-9, "#111111", "blink"}, {0, 0, 1, "#111111", "first"}};
  const std::string svg = svg_of(timeline);
  EXPECT_THAT(svg, HasSubstr("viewBox=\"0 0 1000 862\"")) << "8 a row";
  EXPECT_THAT(svg, Not(HasSubstr(">host 1<")));
  EXPECT_NEAR(sizes_of(svg, "width", "blink").at(0), 0.4, 1e-9) << "it can be seen";
  timeline.rows.resize(40);
  timeline.spans[0].row = 39;
  EXPECT_THAT(svg_of(timeline), HasSubstr(">host 1<"));
}

TEST(SvgCharts, of_points_have_the_line_where_what_came_is_what_was_expected) {
  PointChart chart{.title = "T", .x_name = "expected", .y_name = "came"};
  chart.points = {{1, 10, "#111111", "much"}, {10, 1, "#222222", "little"}, {5, 0, "#333333", ""}};
  EXPECT_EQ(
      svg_of(chart),
      "<svg viewBox=\"0 0 490 330\" role=\"img\"><text class=\"title\" x=\"62\" "
      "y=\"15\">T</text>"
      "<line class=\"grid\" x1=\"62.0\" y1=\"290.0\" x2=\"482.0\" y2=\"290.0\"/>"
      "<text x=\"57.0\" y=\"294.0\" text-anchor=\"end\">1</text>"
      "<line class=\"grid\" x1=\"62.0\" y1=\"26.0\" x2=\"482.0\" y2=\"26.0\"/>"
      "<text x=\"57.0\" y=\"30.0\" text-anchor=\"end\">10</text>"
      "<line class=\"grid\" x1=\"62.0\" y1=\"26.0\" x2=\"62.0\" y2=\"290.0\"/>"
      "<text x=\"62.0\" y=\"305.0\" text-anchor=\"middle\">1</text>"
      "<line class=\"grid\" x1=\"482.0\" y1=\"26.0\" x2=\"482.0\" y2=\"290.0\"/>"
      "<text x=\"482.0\" y=\"305.0\" text-anchor=\"middle\">10</text>"
      "<line class=\"equal\" x1=\"62.0\" y1=\"290.0\" x2=\"482.0\" y2=\"26.0\"/>"
      "<text x=\"276.0\" y=\"324.0\" text-anchor=\"middle\">expected</text>"
      "<text x=\"68.0\" y=\"38.0\" text-anchor=\"start\">came</text>"
      "<circle cx=\"62.0\" cy=\"26.0\" r=\"3\" fill=\"#111111\"><title>much</title></circle>"
      "<circle cx=\"482.0\" cy=\"290.0\" r=\"3\" fill=\"#222222\"><title>little</title></circle>"
      "</svg>");
}

TEST(SvgCharts, have_marks_at_round_numbers) {
  const auto marks_up_to = [](double largest) {
    const std::string svg =
        svg_of(BarChart{.title = "", .names = {"a"}, .series = {{"", "#111111", {largest}}}});
    const std::regex mark("text-anchor=\"end\">([^<]*)<");
    std::string marks;
    for (std::sregex_iterator found(svg.begin(), svg.end(), mark), end; found != end; ++found) {
      marks += (*found)[1].str() + " ";
    }
    return marks;
  };
  EXPECT_EQ(marks_up_to(5), "0 1 2 3 4 5 ");
  EXPECT_EQ(marks_up_to(6), "0 2 4 6 ");
  EXPECT_EQ(marks_up_to(24), "0 5 10 15 20 ");
  EXPECT_EQ(marks_up_to(30), "0 10 20 30 ");
  EXPECT_EQ(marks_up_to(0), "0 0.2 0.4 0.6 0.8 1 ") << "nothing is there";
}

TEST(SvgCharts, numbers_change_their_units_where_they_become_long) {
  EXPECT_EQ(short_number(9999), "9999");
  EXPECT_EQ(short_number(10'000), "10 k");
  EXPECT_EQ(short_number(999), "999");
  EXPECT_EQ(short_number(-12'345), "-12.3 k");
  EXPECT_EQ(short_number(1e6), "1 M");
  EXPECT_EQ(short_number(2.5e9), "2.5 G");
  EXPECT_EQ(short_number(2.5e11), "250 G");
  EXPECT_EQ(short_number(1e12), "1e+12");
  EXPECT_EQ(short_number(0.1234), "0.123");
}

TEST(SvgCharts, of_many_decades_have_few_marks) {
  const std::string svg = svg_of(BarChart{.title = "",
                                          .names = {"a", "b"},
                                          .series = {{"", "#111111", {1e-6, 1e6}}},
                                          .is_logarithmic = true});
  std::string marks;
  const std::regex mark("text-anchor=\"end\">([^<]*)<");
  for (std::sregex_iterator found(svg.begin(), svg.end(), mark), end; found != end; ++found) {
    marks += (*found)[1].str() + " ";
  }
  EXPECT_EQ(marks, "1e-07 0.0001 0.1 100 100 k ");
}

}  // namespace
}  // namespace tetfarm
