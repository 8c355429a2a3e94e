#include "mesh/render/stroke_font.h"

#include <algorithm>
#include <array>

#include "base/check.h"

namespace tetfarm {
namespace {

/// Lines one after the other: '-' straight, '(' curved, 'o' curved and closed; then the points, two
/// digits each. Small letters reach from 2 to 7, digits to 9, and what hangs down to 0.
struct Glyph {
  char letter;
  int width;
  std::string_view lines;
};
constexpr int baseline = 2;
constexpr int digit_height = 7;
constexpr int gap = 2;  // between letters

constexpr std::array glyphs = {Glyph{'0', 5, "o0252545759090704"},
                               Glyph{'1', 5, "-173932"},
                               Glyph{'2', 5, "(0709595602-0252"},
                               Glyph{'3', 5, "(0809595626(2656520204"},
                               Glyph{'4', 5, "-42490454"},
                               Glyph{'5', 5, "-490905(050656520203"},
                               Glyph{'6', 5, "o02525606(49080804"},
                               Glyph{'7', 5, "-095922"},
                               Glyph{'8', 5, "o06565909o02525606"},
                               Glyph{'9', 5, "o05555909(57535312"},
                               Glyph{'-', 4, "-0545"},
                               Glyph{'+', 4, "-0545-2723"},
                               Glyph{'.', 1, "-0202"},
                               Glyph{' ', 2, ""},
                               Glyph{'a', 4, "o02424707-4742"},
                               Glyph{'c', 4, "(464707024243"},
                               Glyph{'e', 4, "-0545(454707024243"},
                               Glyph{'g', 4, "o02424707(4742400001"},
                               Glyph{'h', 4, "-0902(05074742"},
                               Glyph{'i', 1, "-0702-0909"},
                               Glyph{'n', 4, "-0702(05074742"},
                               Glyph{'o', 4, "o02424707"},
                               Glyph{'p', 4, "o02424707-0700"},
                               Glyph{'r', 3, "-0702(050737"},
                               Glyph{'t', 3, "-1913(131232-0737"},
                               Glyph{'x', 4, "-0742-4702"},
                               Glyph{'y', 4, "-0722-4700"}};

const Glyph* glyph_of(char letter) {
  const auto found = std::find_if(glyphs.begin(), glyphs.end(),
                                  [letter](const Glyph& glyph) { return glyph.letter == letter; });
  return found == glyphs.end() ? nullptr : &*found;
}

int advance_of(char letter) {
  const Glyph* glyph = glyph_of(letter);
  return (glyph == nullptr ? 2 : glyph->width) + gap;
}

Vec2 between(const Vec2& a, const Vec2& b, double share) {
  return {a.x + (b.x - a.x) * share, a.y + (b.y - a.y) * share};
}

/// Points that lead the curve from where it ends to the next place, bent towards a point.
void add_bend(std::vector<Vec2>& curve, const Vec2& bend, const Vec2& to) {
  constexpr int pieces = 5;
  const Vec2 from = curve.back();
  for (int i = 1; i <= pieces; ++i) {
    const double share = static_cast<double>(i) / pieces;
    curve.push_back(between(between(from, bend, share), between(bend, to, share), share));
  }
}

std::vector<Vec2> curved(const std::vector<Vec2>& points, bool is_closed) {
  const std::size_t count = points.size();
  TF_CHECK(count >= 3);
  const auto middle = [&](std::size_t i) {
    return between(points[i % count], points[(i + 1) % count], 0.5);
  };
  std::vector<Vec2> curve = {is_closed ? middle(0) : points.front()};
  for (std::size_t i = 1; i <= (is_closed ? count : count - 2); ++i) {
    const bool is_last = !is_closed && i == count - 2;
    add_bend(curve, points[i % count], is_last ? points.back() : middle(i));
  }
  return curve;
}

/// The next line of a glyph, taken off from what is left of them.
std::vector<Vec2> next_line(std::string_view& lines) {
  const char kind = lines.front();
  lines.remove_prefix(1);
  std::vector<Vec2> points;
  while (lines.size() >= 2 && lines.front() >= '0' && lines.front() <= '9') {
    points.push_back({static_cast<double>(lines[0] - '0'), static_cast<double>(lines[1] - '0')});
    lines.remove_prefix(2);
  }
  return kind == '-' ? points : curved(points, kind == 'o');
}

}  // namespace

double text_width(std::string_view text, double height) {
  int units = 0;
  for (const char letter : text) units += advance_of(letter);
  return std::max(units - gap, 0) * height / digit_height;
}

std::vector<Stroke> text_strokes(std::string_view text, const Vec2& at, double height) {
  const double unit = height / digit_height;
  const double width = std::max(0.115 * height, 1.0);
  std::vector<Stroke> strokes;
  double x = at.x;
  for (const char letter : text) {
    const Glyph* glyph = glyph_of(letter);
    std::string_view lines = glyph == nullptr ? std::string_view{} : glyph->lines;
    while (!lines.empty()) {
      std::vector<Vec2> line = next_line(lines);
      for (Vec2& p : line) p = {x + p.x * unit, at.y - (p.y - baseline) * unit};
      for (std::size_t i = 1; i < line.size(); ++i) {
        strokes.push_back(
            {line[i - 1], line[i], line.size() == 2 && line[0] == line[1] ? 1.3 * width : width});
      }
    }
    x += advance_of(letter) * unit;
  }
  return strokes;
}

}  // namespace tetfarm
