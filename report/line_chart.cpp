#include "report/line_chart.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"
#include "base/error.h"
#include "mesh/render/axis_ticks.h"
#include "report/html_text.h"
#include "report/svg_elements.h"

namespace tetfarm {
namespace {

constexpr double chart_left = 72;
constexpr double chart_right = 18;
constexpr double chart_top = 34;
constexpr double chart_bottom = 48;

/// From values to places along one side of the chart.
class ChartAxis {
 public:
  ChartAxis(double low, double high, double from, double to, double room_each)
      : from_(from), to_(to) {
    constexpr double margin = 0.03;
    const double range = high - low;
    if (!std::isfinite(range)) {
      throw UsageError("the values are too far apart to be drawn on one axis", "--field");
    }
    const double largest = std::max(std::fabs(low), std::fabs(high));
    const double rim = range > 1e-9 * largest ? margin * range : largest > 0 ? 0.5 * largest : 1;
    low_ = low - rim;
    high_ = high + rim;
    ticks_ =
        axis_ticks(low_, high_, std::max(2, static_cast<int>(std::fabs(to - from) / room_each)));
  }
  double at(double value) const { return from_ + (value - low_) / (high_ - low_) * (to_ - from_); }
  const std::vector<AxisTick>& ticks() const { return ticks_; }

 private:
  double from_;
  double to_;
  double low_ = 0;
  double high_ = 1;
  std::vector<AxisTick> ticks_;
};

struct ChartRange {
  Vec2 low{HUGE_VAL, HUGE_VAL};
  Vec2 high{-HUGE_VAL, -HUGE_VAL};
};

ChartRange range_of(const LineChart& chart) {
  ChartRange range;
  for (const LineChart::Curve& curve : chart.curves) {
    for (const auto& piece : curve.pieces) {
      for (const Vec2& p : piece) {
        TF_CHECK(std::isfinite(p.x) && std::isfinite(p.y));
        range.low = {std::min(range.low.x, p.x), std::min(range.low.y, p.y)};
        range.high = {std::max(range.high.x, p.x), std::max(range.high.y, p.y)};
      }
    }
  }
  return range;
}

std::string head(const LineChart& chart) {
  return formatted(
             "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %d %d\" width=\"%d\" "
             "height=\"%d\" role=\"img\">\n",
             chart.width, chart.height, chart.width, chart.height) +
         "<style>text{font:13px sans-serif;fill:#333}.grid{stroke:#e2e2e2}.axis{stroke:#666}"
         "polyline{fill:none;stroke-width:1.8;stroke-linejoin:round}</style>\n"
         "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n";
}

std::string curve_lines(const LineChart::Curve& curve, const ChartAxis& across,
                        const ChartAxis& up) {
  std::string svg;
  for (const auto& piece : curve.pieces) {
    svg += "<polyline stroke=\"" + escaped(curve.colour) + "\" points=\"";
    for (const Vec2& p : piece) svg += formatted("%.2f,%.2f ", across.at(p.x), up.at(p.y));
    svg.back() = '"';
    svg += "><title>" + escaped(curve.name) + "</title></polyline>\n";
  }
  return svg;
}

std::string names_of_curves(const LineChart& chart) {
  constexpr double letter = 7.2;
  std::string svg;
  double x = chart_left;
  for (const LineChart::Curve& curve : chart.curves) {
    if (curve.name.empty()) continue;
    svg += formatted("<rect x=\"%.1f\" y=\"15\" width=\"18\" height=\"3\" ", x) + "fill=\"" +
           escaped(curve.colour) + "\"/>" + svg_text(x + 24, 21, "start", curve.name) + "\n";
    x += 24 + letter * static_cast<double>(curve.name.size()) + 22;
  }
  return svg;
}

}  // namespace

std::string svg_file_of(const LineChart& chart) {
  const ChartRange range = range_of(chart);
  TF_CHECK(range.low.x <= range.high.x);
  const double end = chart.width - chart_right;
  const double floor = chart.height - chart_bottom;
  const ChartAxis across(range.low.x, range.high.x, chart_left, end, 80);
  const ChartAxis up(range.low.y, range.high.y, chart.is_reversed ? chart_top : floor,
                     chart.is_reversed ? floor : chart_top, 45);
  std::string svg = head(chart);
  for (const AxisTick& tick : up.ticks()) {
    svg += svg_line(chart_left, up.at(tick.value), end, up.at(tick.value), "grid");
    svg += svg_text(chart_left - 8, up.at(tick.value) + 4.5, "end", tick.text) + "\n";
  }
  for (const AxisTick& tick : across.ticks()) {
    svg += svg_line(across.at(tick.value), chart_top, across.at(tick.value), floor, "grid");
    svg += svg_text(across.at(tick.value), floor + 19, "middle", tick.text) + "\n";
  }
  svg += svg_line(chart_left, floor, end, floor, "axis") +
         svg_line(chart_left, chart_top, chart_left, floor, "axis");
  svg += svg_text((chart_left + end) / 2, chart.height - 8.0, "middle", chart.x_name);
  svg += formatted("<g transform=\"translate(16,%.1f) rotate(-90)\">", (chart_top + floor) / 2) +
         svg_text(0, 0, "middle", chart.y_name) + "</g>\n";
  for (const LineChart::Curve& curve : chart.curves) svg += curve_lines(curve, across, up);
  return svg + names_of_curves(chart) + "</svg>\n";
}

}  // namespace tetfarm
