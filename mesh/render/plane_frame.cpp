#include "mesh/render/plane_frame.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"
#include "base/error.h"
#include "mesh/render/axis_ticks.h"
#include "mesh/render/stroke_font.h"

namespace tetfarm {
namespace {

// In heights of a digit.
constexpr double left_margin = 7.5;
constexpr double bottom_margin = 4;
constexpr double plain_margin = 2;
constexpr double bar_margin = 12;
constexpr double legend_margin = 11;
constexpr double gap_beside = 1.5;
constexpr double bar_width = 1.6;
constexpr double tick_length = 0.5;
constexpr double line_pitch = 2;

/// The room of a picture that its margins leave.
struct SheetRoom {
  double left = 0;
  double top = 0;
  double width = 1;
  double height = 1;
  double text_height = 0;
};

SheetRoom room_of(int width, int height, Beside beside) {
  const double text = std::max(0.0106 * std::sqrt(static_cast<double>(width) * height), 6.5);
  const double right = beside == Beside::colour_bar ? bar_margin
                       : beside == Beside::legend   ? legend_margin
                                                    : plain_margin;
  const SheetRoom room{left_margin * text, plain_margin * text,
                       width - (left_margin + right) * text,
                       height - (plain_margin + bottom_margin) * text, text};
  const bool is_large_enough = room.width > 60 && room.height > 40;
  return is_large_enough ? room : SheetRoom{0, 0, 1.0 * width, 1.0 * height, 0};
}

Vec2 middle_of(const PlaneBox& box) {
  return {box.low.x + (box.high.x - box.low.x) / 2, box.low.y + (box.high.y - box.low.y) / 2};
}

/// What is seen, which has the shape of the room unless all is seen.
PlaneBox seen_box(const PlaneBox& all, const PlaneWindow& window, const SheetRoom& room) {
  constexpr double rim_share = 0.02;
  const double width = all.high.x - all.low.x;
  const double height = all.high.y - all.low.y;
  const double rim = rim_share * std::max(width, height);
  const double smallest = rim > 0 ? 2 * rim : 1;
  const Vec2 half{std::max(width / 2 + rim, smallest / 2),
                  std::max(height / 2 + rim, smallest / 2)};
  const Vec2 middle = window.centre.value_or(middle_of(all));
  if (window.shows_all()) {
    return {{middle.x - half.x, middle.y - half.y}, {middle.x + half.x, middle.y + half.y}};
  }
  const double fitting = 2 * std::max(half.x, half.y * room.width / room.height);
  const double across = window.across.value_or(fitting / window.zoom);
  const double up = across * room.height / room.width;
  return {{middle.x - across / 2, middle.y - up / 2}, {middle.x + across / 2, middle.y + up / 2}};
}

void require_width(const PlaneBox& seen, bool shows_all) {
  const double width = seen.high.x - seen.low.x;
  const double height = seen.high.y - seen.low.y;
  const double largest = std::max({std::fabs(seen.low.x), std::fabs(seen.low.y),
                                   std::fabs(seen.high.x), std::fabs(seen.high.y)});
  if (std::isfinite(width) && std::isfinite(height) && std::min(width, height) > 1e-12 * largest) {
    return;
  }
  throw UsageError("what would be seen is too small or too large beside its coordinates",
                   shows_all ? "render" : "--across, --zoom or --centre");
}

void draw_text(PlaneCanvas& canvas, const std::string& text, const Vec2& at, double height) {
  canvas.draw_line(text_strokes(text, at, height), plane_ink);
}

double line_width(const PlaneFrame& frame) { return std::max(1.0, 0.08 * frame.text_height); }

void draw_rectangle(PlaneCanvas& canvas, const PixelBox& box, double width) {
  const Vec2 a{static_cast<double>(box.left), static_cast<double>(box.top)};
  const Vec2 b{static_cast<double>(box.right), static_cast<double>(box.bottom)};
  canvas.draw_line(std::vector<Stroke>{{a, {b.x, a.y}, width},
                                       {{b.x, a.y}, b, width},
                                       {b, {a.x, b.y}, width},
                                       {{a.x, b.y}, a, width}},
                   plane_ink);
}

void fill_rectangle(PlaneCanvas& canvas, const Vec2& a, const Vec2& b, const Colour& colour) {
  const auto shade = [&colour](const auto&) { return colour; };
  canvas.fill({a, Vec2{b.x, a.y}, b}, shade);
  canvas.fill({a, b, Vec2{a.x, b.y}}, shade);
}

int most_ticks(double length, double room_each) {
  return std::max(2, static_cast<int>(length / room_each));
}

}  // namespace

PlaneFrame plane_frame(const PlaneBox& all, const PlaneWindow& window, int width, int height,
                       Beside beside) {
  TF_CHECK(width > 0 && height > 0);
  const SheetRoom room = room_of(width, height, beside);
  const PlaneBox seen = seen_box(all, window, room);
  require_width(seen, window.shows_all());
  const double seen_width = seen.high.x - seen.low.x;
  const double seen_height = seen.high.y - seen.low.y;
  PlaneFrame frame;
  frame.pixels_per_unit = std::min(room.width / seen_width, room.height / seen_height);
  frame.text_height = room.text_height;
  const auto pixels = [&](double length) {
    return std::max(1, static_cast<int>(std::lround(length * frame.pixels_per_unit)));
  };
  const int columns = pixels(seen_width);
  const int rows = pixels(seen_height);
  const int left = static_cast<int>(std::lround(room.left + (room.width - columns) / 2));
  const int top = static_cast<int>(std::lround(room.top + (room.height - rows) / 2));
  frame.pixels = {left, top, left + columns, top + rows};
  frame.low = seen.low;
  return frame;
}

void draw_axes(PlaneCanvas& canvas, const PlaneFrame& frame) {
  const double text = frame.text_height;
  if (!(text > 0)) return;
  const PixelBox& box = frame.pixels;
  const double width = line_width(frame);
  draw_rectangle(canvas, box, width);
  std::vector<Stroke> marks;
  const double length = tick_length * text;
  for (const AxisTick& tick :
       axis_ticks(frame.low.x, frame.high().x, most_ticks(box.width(), 7 * text))) {
    const double x = frame.to_pixel({tick.value, 0}).x;
    marks.push_back({{x, 1.0 * box.bottom}, {x, box.bottom + length}, width});
    draw_text(canvas, tick.text,
              {x - text_width(tick.text, text) / 2, box.bottom + length + 1.6 * text}, text);
  }
  for (const AxisTick& tick :
       axis_ticks(frame.low.y, frame.high().y, most_ticks(box.height(), 5.5 * text))) {
    const double y = frame.to_pixel({0, tick.value}).y;
    marks.push_back({{1.0 * box.left, y}, {box.left - length, y}, width});
    draw_text(canvas, tick.text,
              {box.left - length - 0.6 * text - text_width(tick.text, text), y + text / 2}, text);
  }
  canvas.draw_line(marks, plane_ink);
}

void draw_colour_bar(PlaneCanvas& canvas, const PlaneFrame& frame, const FieldLevels& levels) {
  const double text = frame.text_height;
  if (!(text > 0)) return;
  const int left = frame.pixels.right + static_cast<int>(std::lround(gap_beside * text));
  const int right = left + static_cast<int>(std::lround(bar_width * text));
  const PixelBox bar{left, frame.pixels.top, right, frame.pixels.bottom};
  for (int level = 0; level < levels.count; ++level) {
    const auto y = [&](int edge) { return bar.bottom - 1.0 * bar.height() * edge / levels.count; };
    fill_rectangle(canvas, {1.0 * left, y(level + 1)}, {1.0 * right, y(level)},
                   levels.colour_of_level(level));
  }
  const double width = line_width(frame);
  draw_rectangle(canvas, bar, width);
  std::vector<Stroke> marks;
  const double length = tick_length * text;
  for (const AxisTick& tick :
       axis_ticks(levels.low, levels.high, most_ticks(bar.height(), 3 * text))) {
    const double share = (tick.value - levels.low) / (levels.high - levels.low);
    const double y = bar.bottom - share * bar.height();
    marks.push_back({{1.0 * right, y}, {right + length, y}, width});
    draw_text(canvas, tick.text, {right + length + 0.6 * text, y + text / 2}, text);
  }
  canvas.draw_line(marks, plane_ink);
}

void draw_legend(PlaneCanvas& canvas, const PlaneFrame& frame,
                 const std::vector<LegendEntry>& entries) {
  const double text = frame.text_height;
  if (!(text > 0)) return;
  const double left = frame.pixels.right + gap_beside * text;
  const double swatch = 2 * text;
  double y = frame.pixels.top + text;
  for (const LegendEntry& entry : entries) {
    if (y + line_pitch * text > frame.pixels.bottom && &entry != &entries.back()) {
      draw_text(canvas, "...", {left, y}, text);
      return;
    }
    if (entry.is_line) {
      const double middle = y - text / 2;
      canvas.draw_line(std::vector<Stroke>{{{left, middle}, {left + swatch, middle}, 0.25 * text}},
                       entry.colour);
    } else {
      fill_rectangle(canvas, {left, y - text}, {left + swatch, y}, entry.colour);
    }
    draw_text(canvas, entry.text, {left + swatch + 0.6 * text, y}, text);
    y += line_pitch * text;
  }
}

}  // namespace tetfarm
