/// Charts as SVG that stands in a page: bars, a timeline, points.
///
/// No scripts, no fonts and no addresses of their own; colours are those of the page's classes.
/// What is pointed at says its figures (`<title>`). The same numbers give the same bytes.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace tetfarm {

/// Bars side by side, one of each series at each name.
struct BarChart {
  std::string title;
  std::string unit = {};                ///< of the axis across
  std::vector<std::string> names = {};  ///< of the bins; as many are shown as have room
  struct Series {
    std::string name;
    std::string colour;
    std::vector<double> values;
  };
  std::vector<Series> series = {};
  bool is_logarithmic = false;  ///< from a tenth of the smallest value that is not 0
  bool is_wide = false;         ///< over the whole page
};
/// @pre every series has as many values as there are names.
std::string svg_of(const BarChart& chart);

/// Each in percent of their sum; of nothing at all 0.
std::vector<double> shares(std::span<const std::int64_t> counts);

/// Spans of time in rows, the first row on top.
struct Timeline {
  std::vector<std::string> rows;
  struct Span {
    std::size_t row = 0;
    double from_s = 0;
    double to_s = 0;
    std::string colour;
    std::string what;
  };
  std::vector<Span> spans;
};
/// At most 20,000 spans are drawn, the longest; says so where there are more.
std::string svg_of(Timeline timeline);

/// What was expected and what came, both on logarithmic axes with the line where they are equal.
struct PointChart {
  std::string title;
  std::string x_name;
  std::string y_name;
  struct Point {
    double x = 0;  ///< what is not above 0 is left out
    double y = 0;
    std::string colour;
    std::string what;
  };
  std::vector<Point> points = {};
};
std::string svg_of(const PointChart& chart);

/// A number in few digits: "0", "12", "3.5 M", "2.1e-09".
std::string short_number(double value);

}  // namespace tetfarm
