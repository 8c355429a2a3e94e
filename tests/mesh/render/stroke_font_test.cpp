#include "mesh/render/stroke_font.h"

#include <gtest/gtest.h>

namespace tetfarm {
namespace {

TEST(StrokeFont, keeps_within_the_width_and_height_that_it_tells) {
  for (const char* text : {"0", "-12.5e+3", "3467890", "patch 1", "region 2"}) {
    const double width = text_width(text, 14);
    EXPECT_GT(width, 0);
    for (const Stroke& stroke : text_strokes(text, {100, 50}, 14)) {
      for (const Vec2& p : {stroke.from, stroke.to}) {
        EXPECT_GE(p.x, 100) << text;
        EXPECT_LE(p.x, 100 + width + 1e-9) << text;
        EXPECT_GE(p.y, 50 - 14 - 1e-9) << text;
        EXPECT_LE(p.y, 50 + 4 + 1e-9) << "letters that hang down" << text;
      }
    }
  }
}

TEST(StrokeFont, has_digits_from_the_line_to_their_height) {
  for (const char digit : {'0', '1', '2', '3', '4', '5', '6', '7', '8', '9'}) {
    double top = 1e9;
    double bottom = -1e9;
    for (const Stroke& stroke : text_strokes(std::string(1, digit), {0, 0}, 7)) {
      top = std::min({top, stroke.from.y, stroke.to.y});
      bottom = std::max({bottom, stroke.from.y, stroke.to.y});
    }
    EXPECT_NEAR(top, -7, 1e-9) << digit;
    EXPECT_NEAR(bottom, 0, 1e-9) << digit;
  }
}

TEST(StrokeFont, has_lines_that_hang_together) {
  // No piece of a curve is longer than a digit: all pieces join.
  for (const Stroke& stroke : text_strokes("0235689", {0, 0}, 7)) {
    const double dx = stroke.to.x - stroke.from.x;
    const double dy = stroke.to.y - stroke.from.y;
    EXPECT_LE(dx * dx + dy * dy, 5 * 5 + 1e-9);
  }
}

TEST(StrokeFont, leaves_a_gap_for_what_it_does_not_have) {
  EXPECT_TRUE(text_strokes("%", {0, 0}, 7).empty());
  EXPECT_GT(text_width("1%1", 7), text_width("11", 7));
  EXPECT_EQ(text_width("", 7), 0);
}

}  // namespace
}  // namespace tetfarm
