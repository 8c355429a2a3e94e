#include "mesh/render/canvas.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace tetfarm {
namespace {

constexpr Colour red{1, 0, 0};
constexpr Colour blue{0, 0, 1};
constexpr double no_outline = HUGE_VAL;

std::array<int, 3> pixel(const Picture& picture, int x, int y) {
  const auto i = static_cast<std::size_t>(3 * (y * picture.width + x));
  return {picture.bytes[i], picture.bytes[i + 1], picture.bytes[i + 2]};
}

/// The square of 60 pixels in the middle of a picture of 100, as two triangles.
void draw_square(Canvas& canvas, const Colour& colour, double depth) {
  canvas.draw({{{20, 20, depth}, {80, 20, depth}, {80, 80, depth}}}, colour);
  canvas.draw({{{20, 20, depth}, {20, 80, depth}, {80, 80, depth}}}, colour);
}

CanvasOptions options(double edge_width) { return {100, 100, 3, edge_width, {1, 1, 1}}; }

TEST(Canvas, has_no_hole_in_the_edge_of_two_triangles_whichever_way_it_runs) {
  for (int i = 0; i < 100; ++i) {
    Canvas canvas({100, 100, 1, 0, {1, 1, 1}});
    // Through the middle of a pixel.
    const double across = 40 * std::cos(i);
    const double up = 40 * std::sin(i);
    const Seen one{50.5 - across, 50.5 - up, 1};
    const Seen other{50.5 + across / 3, 50.5 + up / 3, 1};
    canvas.draw({one, other, Seen{50.5 + up, 50.5 - across, 1}}, red);
    canvas.draw({other, one, Seen{50.5 - up, 50.5 + across, 1}}, red);
    EXPECT_EQ(pixel(canvas.picture(no_outline), 50, 50), (std::array<int, 3>{255, 0, 0})) << i;
  }
}

TEST(Canvas, shows_the_nearest_whatever_is_drawn_first) {
  for (const bool near_first : {false, true}) {
    Canvas canvas(options(0));
    draw_square(canvas, near_first ? red : blue, near_first ? 1 : 2);
    draw_square(canvas, near_first ? blue : red, near_first ? 2 : 1);
    const Picture picture = canvas.picture(no_outline);
    EXPECT_EQ(pixel(picture, 50, 45), (std::array<int, 3>{255, 0, 0}));
    EXPECT_EQ(pixel(picture, 10, 50), (std::array<int, 3>{255, 255, 255}));
  }
}

TEST(Canvas, covers_the_area_of_a_triangle_without_gaps_between_neighbours) {
  Canvas canvas(options(0));
  draw_square(canvas, red, 1);
  const Picture picture = canvas.picture(no_outline);
  int covered = 0;
  for (int y = 0; y < 100; ++y) {
    for (int x = 0; x < 100; ++x) covered += pixel(picture, x, y)[1] == 0 ? 1 : 0;
  }
  EXPECT_EQ(covered, 60 * 60);
}

TEST(Canvas, sees_which_of_two_slanted_triangles_is_nearer_at_each_pixel) {
  Canvas canvas(options(0));
  canvas.draw({{{0, 0, 1}, {0, 100, 1}, {100, 50, 3}}}, red);     // near on the left
  canvas.draw({{{100, 0, 1}, {100, 100, 1}, {0, 50, 3}}}, blue);  // near on the right
  const Picture picture = canvas.picture(no_outline);
  EXPECT_EQ(pixel(picture, 30, 50), (std::array<int, 3>{255, 0, 0}));
  EXPECT_EQ(pixel(picture, 70, 50), (std::array<int, 3>{0, 0, 255}));
}

TEST(Canvas, darkens_edges_of_large_triangles_but_not_of_tiny_ones) {
  Canvas canvas(options(2));
  draw_square(canvas, red, 2);
  for (int i = 0; i < 30; ++i) {
    for (int j = 0; j < 30; ++j) {
      const double x = 5 + 0.5 * i;
      const double y = 5 + 0.4 * j;
      canvas.draw({{{x, y, 1}, {x + 0.5, y, 1}, {x, y + 0.4, 1}}}, blue);
      canvas.draw({{{x + 0.5, y + 0.4, 1}, {x + 0.5, y, 1}, {x, y + 0.4, 1}}}, blue);
    }
  }
  const Picture picture = canvas.picture(no_outline);
  EXPECT_LT(pixel(picture, 50, 50)[0], 130) << "on the diagonal edge";
  EXPECT_EQ(pixel(picture, 65, 45)[0], 255) << "inside of a triangle";
  EXPECT_EQ(pixel(picture, 10, 8), (std::array<int, 3>{0, 0, 255})) << "among tiny triangles";
}

TEST(Canvas, outlines_what_stands_before_something_farther_away) {
  Canvas canvas(options(0));
  draw_square(canvas, red, 1);
  const Picture plain = canvas.picture(no_outline);
  const Picture outlined = canvas.picture(0.1);
  EXPECT_EQ(pixel(plain, 20, 50)[0], 255);
  EXPECT_LT(pixel(outlined, 20, 50)[0], 200);
  EXPECT_EQ(pixel(outlined, 50, 45)[0], 255);
}

TEST(Canvas, passes_over_triangles_without_area_and_outside) {
  Canvas canvas(options(1));
  canvas.draw({{{10, 10, 1}, {50, 50, 1}, {90, 90, 1}}}, red);
  canvas.draw({{{-50, -50, 1}, {-10, -50, 1}, {-50, -10, 1}}}, red);
  canvas.draw({{{500, 500, 1}, {600, 500, 1}, {500, 600, 1}}}, red);
  const Picture picture = canvas.picture(0.1);
  EXPECT_TRUE(std::all_of(picture.bytes.begin(), picture.bytes.end(),
                          [](std::uint8_t byte) { return byte == 255; }));
}

TEST(Canvas, keeps_the_first_of_two_that_are_equally_near) {
  Canvas canvas(options(0));
  draw_square(canvas, red, 2);
  draw_square(canvas, blue, 2);
  EXPECT_EQ(pixel(canvas.picture(no_outline), 50, 45), (std::array<int, 3>{255, 0, 0}));
}

TEST(Canvas, draws_no_edge_that_it_is_told_to_leave_out) {
  const auto pixel_on_edge = [](bool has_edge) {
    Canvas canvas(options(4));
    canvas.draw({{{10, 10, 1}, {90, 10, 1}, {10, 90, 1}}}, red, {true, has_edge, true});
    return pixel(canvas.picture(no_outline), 10, 45);
  };
  EXPECT_NE(pixel_on_edge(true), (std::array<int, 3>{255, 0, 0}));
  EXPECT_EQ(pixel_on_edge(false), (std::array<int, 3>{255, 0, 0}));
}

TEST(Canvas, takes_no_slope_for_a_step) {
  Canvas canvas(options(0));
  // Its depth grows from 1 to 5 over the picture: by 0.02 a pixel in its middle.
  canvas.draw({{{0, 0, 1}, {0, 100, 1}, {100, 50, 5}}}, red);
  const Picture picture = canvas.picture(0.001);
  EXPECT_EQ(pixel(picture, 40, 50), (std::array<int, 3>{255, 0, 0}));
  EXPECT_EQ(pixel(picture, 10, 50), (std::array<int, 3>{255, 0, 0}));
}

}  // namespace
}  // namespace tetfarm
