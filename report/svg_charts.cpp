#include "report/svg_charts.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"
#include "report/html_text.h"
#include "report/svg_elements.h"

namespace tetfarm {
namespace {

constexpr double left = 62;
constexpr double right = 8;
constexpr double top = 26;
constexpr double bottom = 40;

std::string open(double width, double height, const std::string& title) {
  return formatted("<svg viewBox=\"0 0 %.0f %.0f\" role=\"img\">", width, height) +
         formatted("<text class=\"title\" x=\"%.0f\" y=\"15\">", left) + escaped(title) + "</text>";
}

std::string box(double x, double y, double width, double height, const std::string& colour,
                const std::string& what) {
  return formatted("<rect x=\"%.2f\" y=\"%.2f\" width=\"%.2f\" height=\"%.2f\" ", x, y, width,
                   height) +
         "fill=\"" + colour + "\"><title>" + escaped(what) + "</title></rect>";
}

/// A step of 1, 2 or 5 times a power of ten that divides the range into at most so many.
double round_step(double range, int most) {
  TF_CHECK(range > 0 && most > 0);
  const double power = std::pow(10.0, std::floor(std::log10(range / most)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (range <= factor * power * most) return factor * power;
  }
  return 10 * power;
}

/// Where values come to lie between two places.
class Scale {
 public:
  Scale(double low, double high, double from, double to, bool is_logarithmic)
      : from_(from), to_(to), is_logarithmic_(is_logarithmic) {
    TF_CHECK(!is_logarithmic || (low > 0 && high > 0));
    low_ = is_logarithmic ? std::floor(std::log10(low)) : low;
    high_ = is_logarithmic ? std::ceil(std::log10(high)) : high;
    if (!(high_ > low_)) high_ = low_ + 1;
  }
  double at(double value) const {
    const double x = is_logarithmic_ ? std::log10(value) : value;
    return from_ + (std::clamp(x, low_, high_) - low_) / (high_ - low_) * (to_ - from_);
  }
  std::vector<double> marks() const {
    std::vector<double> marks;
    const double step = is_logarithmic_ ? std::max(1.0, std::ceil((high_ - low_) / 6))
                                        : round_step(high_ - low_, 5);
    for (double x = low_; x <= high_ + 1e-9 * step; x += step) {
      marks.push_back(is_logarithmic_ ? std::pow(10.0, x) : x);
    }
    return marks;
  }

 private:
  double from_;
  double to_;
  bool is_logarithmic_;
  double low_ = 0;
  double high_ = 1;
};

Scale scale_of(const BarChart& chart, double height) {
  double largest = 0;
  double smallest = HUGE_VAL;
  for (const BarChart::Series& series : chart.series) {
    for (const double value : series.values) {
      largest = std::max(largest, value);
      if (value > 0) smallest = std::min(smallest, value);
    }
  }
  if (!(largest > 0)) largest = smallest = 1;
  return {chart.is_logarithmic ? 0.5 * smallest : 0, largest, height - bottom, top,
          chart.is_logarithmic};
}

std::string names_below(const BarChart& chart, double slot, double y) {
  constexpr double least_room = 58;
  const auto step = static_cast<std::size_t>(std::max(1.0, std::ceil(least_room / slot)));
  std::string svg;
  for (std::size_t i = 0; i < chart.names.size(); i += step) {
    svg += svg_text(left + (static_cast<double>(i) + 0.5) * slot, y, "middle", chart.names[i]);
  }
  return svg;
}

std::string legend(const BarChart& chart, double width) {
  constexpr double letter = 6.8;
  std::string svg;
  double x = width - right;
  for (std::size_t i = chart.series.size(); i-- > 0;) {
    const BarChart::Series& series = chart.series[i];
    if (series.name.empty()) continue;
    x -= letter * static_cast<double>(series.name.size());
    svg += svg_text(x, 15, "start", series.name);
    svg += box(x - 14, 6, 10, 10, series.colour, series.name);
    x -= 26;
  }
  return svg;
}

std::string grid(const Scale& scale, double width) {
  std::string svg;
  for (const double mark : scale.marks()) {
    svg += svg_line(left, scale.at(mark), width - right, scale.at(mark), "grid");
    svg += svg_text(left - 5, scale.at(mark) + 4, "end", short_number(mark));
  }
  return svg;
}

/// The longest, in the order that they were in; true when some are left out.
bool keep_longest(std::vector<Timeline::Span>& spans, std::size_t most) {
  if (spans.size() <= most) return false;
  TF_CHECK(most > 0);
  std::vector<double> lengths;
  for (const Timeline::Span& span : spans) lengths.push_back(span.to_s - span.from_s);
  const auto middle = lengths.begin() + static_cast<long>(most);
  std::nth_element(lengths.begin(), middle, lengths.end(), std::greater<>());
  const double least = *middle;
  std::erase_if(spans, [least](const auto& span) { return span.to_s - span.from_s <= least; });
  return true;
}

}  // namespace

std::string short_number(double value) {
  const double size = std::fabs(value);
  if (size >= 1e4 && size < 1e12) {
    constexpr const char* units[] = {" k", " M", " G"};
    double scaled = value;
    std::size_t unit = 0;
    for (scaled /= 1e3; std::fabs(scaled) >= 1e3 && unit < 2; scaled /= 1e3) ++unit;
    return formatted("%.3g", scaled) + units[unit];
  }
  return size >= 1e3 && size < 1e4 ? formatted("%.0f", value) : formatted("%.3g", value);
}

std::string svg_of(const BarChart& chart) {
  const double width = chart.is_wide ? 1000 : 490;
  const double height = chart.is_wide ? 230 : 240;
  const Scale scale = scale_of(chart, height);
  for (const BarChart::Series& series : chart.series) {
    TF_CHECK(series.values.size() == chart.names.size());
  }
  std::string svg = open(width, height, chart.title) + legend(chart, width) + grid(scale, width);
  const auto bins = static_cast<double>(std::max<std::size_t>(chart.names.size(), 1));
  const double slot = (width - left - right) / bins;
  const double bar = 0.86 * slot / static_cast<double>(chart.series.size());
  for (std::size_t i = 0; i < chart.names.size(); ++i) {
    for (std::size_t s = 0; s < chart.series.size(); ++s) {
      const double value = chart.series[s].values[i];
      if (!(value > 0)) continue;
      const double x = left + (static_cast<double>(i) + 0.07) * slot + static_cast<double>(s) * bar;
      const double y = scale.at(value);
      svg += box(x, y, bar, height - bottom - y, chart.series[s].colour,
                 chart.names[i] + ": " + formatted("%.4g ", value) + chart.series[s].name);
    }
  }
  svg += svg_line(left, height - bottom, width - right, height - bottom, "axis");
  svg += names_below(chart, slot, height - bottom + 15);
  return svg + svg_text((left + width - right) / 2, height - 6, "middle", chart.unit) + "</svg>";
}

std::string svg_of(Timeline timeline) {
  constexpr std::size_t most_spans = 20'000;
  constexpr double width = 1000;
  constexpr double labels = 130;
  const bool has_more = keep_longest(timeline.spans, most_spans);
  const double row = timeline.rows.size() > 40
                         ? std::max(2.0, 800.0 / static_cast<double>(timeline.rows.size()))
                         : 20;
  const double height = top + row * static_cast<double>(timeline.rows.size()) + 36;
  double end = 0;
  for (const Timeline::Span& span : timeline.spans) end = std::max(end, span.to_s);
  const Scale scale(0, end > 0 ? end : 1, labels, width - right, false);
  std::string svg = open(width, height, has_more ? "the longest attempts only" : "");
  for (const double mark : scale.marks()) {
    svg += svg_line(scale.at(mark), top, scale.at(mark), height - 34, "grid");
    svg += svg_text(scale.at(mark), height - 20, "middle", short_number(mark));
  }
  svg += svg_text((labels + width) / 2, height - 5, "middle", "seconds since the first attempt");
  for (std::size_t i = 0; i < timeline.rows.size() && row >= 10; ++i) {
    svg +=
        svg_text(labels - 6, top + (static_cast<double>(i) + 0.7) * row, "end", timeline.rows[i]);
  }
  for (const Timeline::Span& span : timeline.spans) {
    const double x = scale.at(span.from_s);
    TF_CHECK(span.row < timeline.rows.size());
    svg += box(x, top + (static_cast<double>(span.row) + 0.1) * row,
               std::max(scale.at(span.to_s) - x, 0.4), 0.8 * row, span.colour, span.what);
  }
  return svg + "</svg>";
}

std::string svg_of(const PointChart& chart) {
  constexpr double width = 490;
  constexpr double height = 330;
  double low = HUGE_VAL;
  double high = 0;
  for (const PointChart::Point& point : chart.points) {
    if (!(point.x > 0 && point.y > 0)) continue;
    low = std::min({low, point.x, point.y});
    high = std::max({high, point.x, point.y});
  }
  std::string svg = open(width, height, chart.title);
  if (!(high > 0)) return svg + "</svg>";
  const Scale across(low, high, left, width - right, true);
  const Scale up(low, high, height - bottom, top, true);
  svg += grid(up, width);
  for (const double mark : across.marks()) {
    svg += svg_line(across.at(mark), top, across.at(mark), height - bottom, "grid");
    svg += svg_text(across.at(mark), height - bottom + 15, "middle", short_number(mark));
  }
  svg += svg_line(across.at(low), up.at(low), across.at(high), up.at(high), "equal");
  svg += svg_text((left + width) / 2, height - 6, "middle", chart.x_name);
  svg += svg_text(left + 6, top + 12, "start", chart.y_name);
  for (const PointChart::Point& point : chart.points) {
    if (!(point.x > 0 && point.y > 0)) continue;
    svg +=
        formatted("<circle cx=\"%.1f\" cy=\"%.1f\" r=\"3\" ", across.at(point.x), up.at(point.y)) +
        "fill=\"" + point.colour + "\"><title>" + escaped(point.what) + "</title></circle>";
  }
  return svg + "</svg>";
}

std::vector<double> shares(std::span<const std::int64_t> counts) {
  double sum = 0;
  for (const std::int64_t count : counts) sum += static_cast<double>(count);
  std::vector<double> shares;
  for (const std::int64_t count : counts) {
    shares.push_back(sum > 0 ? 100 * static_cast<double>(count) / sum : 0);
  }
  return shares;
}

}  // namespace tetfarm
