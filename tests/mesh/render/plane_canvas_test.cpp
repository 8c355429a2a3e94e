#include "mesh/render/plane_canvas.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tetfarm {
namespace {

constexpr Colour black{0, 0, 0};
constexpr Colour red{1, 0, 0};

PlaneCanvas::Shade flat(const Colour& colour) {
  return [colour](const auto&) { return colour; };
}

std::array<int, 3> pixel(const Picture& picture, int x, int y) {
  const auto i = static_cast<std::size_t>(3 * (y * picture.width + x));
  return {picture.bytes.at(i), picture.bytes.at(i + 1), picture.bytes.at(i + 2)};
}

/// How much of the picture is not white, in pixels.
double darkness(const Picture& picture) {
  double sum = 0;
  for (const std::uint8_t byte : picture.bytes) sum += (255 - byte) / 255.0 / 3;
  return sum;
}

TEST(PlaneCanvas, covers_each_sample_of_a_fan_exactly_once) {
  // Corners on middles of pixels: the centre and many edges run through samples. Twice covered,
  // black over half white would become lighter or darker than this grey.
  const Vec2 centre{30.5, 30.5};
  PlaneCanvas canvas(61, 61, 1);
  const std::array<Vec2, 8> round = {Vec2{60.5, 30.5}, {60.5, 60.5}, {30.5, 60.5}, {0.5, 60.5},
                                     {0.5, 30.5},      {0.5, 0.5},   {30.5, 0.5},  {60.5, 0.5}};
  int shaded = 0;
  for (std::size_t i = 0; i < 8; ++i) {
    std::array<Vec2, 3> corners = {centre, round[i], round[(i + 1) % 8]};
    if (i % 2 == 0) std::swap(corners[1], corners[2]);
    canvas.fill(corners, [&shaded](const auto&) {
      ++shaded;
      return black;
    });
  }
  const Picture picture = canvas.picture();
  int dark = 0;
  for (int y = 0; y < 61; ++y) {
    for (int x = 0; x < 61; ++x) dark += pixel(picture, x, y)[0] == 0 ? 1 : 0;
  }
  EXPECT_EQ(shaded, dark) << "no sample twice";
  EXPECT_GE(dark, 60 * 60) << "and none left out";
}

TEST(PlaneCanvas, shades_by_barycentric_coordinates_whichever_way_the_corners_turn) {
  for (const bool is_turned : {false, true}) {
    PlaneCanvas canvas(100, 100, 3);
    std::array<Vec2, 3> corners = {Vec2{0, 0}, {100, 0}, {0, 100}};
    if (is_turned) std::swap(corners[1], corners[2]);
    canvas.fill(corners, [](const std::array<double, 3>& share) {
      return Colour{static_cast<float>(share[0]), static_cast<float>(share[1]),
                    static_cast<float>(share[2])};
    });
    const auto [first, second, third] = pixel(canvas.picture(), 60, 20);
    EXPECT_NEAR(first, 255 * 0.19, 1);
    EXPECT_NEAR(is_turned ? third : second, 255 * 0.605, 1);
    EXPECT_NEAR(is_turned ? second : third, 255 * 0.205, 1);
  }
}

TEST(PlaneCanvas, draws_nothing_outside_of_its_clip) {
  PlaneCanvas canvas(40, 40, 2);
  canvas.clip_to({10, 10, 30, 20});
  canvas.fill({Vec2{-1e12, -1e12}, {1e12, -1e12}, {0, 1e12}}, flat(red));
  canvas.draw_line(std::vector<Stroke>{{{-1e9, 15}, {1e9, 15}, 3}}, black);
  canvas.draw_mesh_lines(std::vector<Stroke>{{{20, -1e9}, {20, 1e9}, 3}}, black);
  const Picture picture = canvas.picture();
  for (int y = 0; y < 40; ++y) {
    for (int x = 0; x < 40; ++x) {
      const bool is_inside = x >= 10 && x < 30 && y >= 10 && y < 20;
      EXPECT_EQ(pixel(picture, x, y)[1] < 255, is_inside) << x << " " << y;
    }
  }
}

TEST(PlaneCanvas, gives_lines_the_area_of_their_length_and_width) {
  for (const double width : {0.3, 1.0, 2.5}) {
    for (int i = 0; i < 12; ++i) {
      const Vec2 way{30 * std::cos(i), 30 * std::sin(i)};
      const Stroke stroke{{50 - way.x, 50 - way.y}, {50 + way.x, 50 + way.y}, width};
      PlaneCanvas canvas(100, 100, 1);
      canvas.draw_mesh_lines(std::vector<Stroke>{stroke}, black);
      EXPECT_NEAR(darkness(canvas.picture()), 60 * width, 4 * width) << i;
    }
  }
}

TEST(PlaneCanvas, draws_a_line_of_many_pieces_as_that_of_one) {
  PlaneCanvas whole(60, 60, 1);
  whole.draw_line(std::vector<Stroke>{{{10, 12}, {50, 40}, 2}}, black);
  PlaneCanvas pieces(60, 60, 1);
  std::vector<Stroke> strokes;
  constexpr int count = 1000;
  const auto at = [](int i) { return Vec2{10 + 0.04 * i, 12 + 0.028 * i}; };
  for (int i = 0; i < count; ++i) strokes.push_back({at(i), at(i + 1), 2});
  pieces.draw_line(strokes, black);
  const Picture a = whole.picture();
  const Picture b = pieces.picture();
  for (std::size_t i = 0; i < a.bytes.size(); ++i) EXPECT_NEAR(a.bytes[i], b.bytes[i], 1);
}

TEST(PlaneCanvas, turns_dense_mesh_lines_into_an_even_tone) {
  PlaneCanvas canvas(60, 60, 1);
  std::vector<Stroke> strokes;
  for (int i = 0; i <= 600; ++i) strokes.push_back({{0.1 * i, 0}, {0.1 * i, 60}, 0.04});
  canvas.draw_mesh_lines(strokes, black);
  const Picture picture = canvas.picture();
  for (int x = 5; x < 55; ++x) EXPECT_NEAR(pixel(picture, x, 30)[0], 255 * 0.6, 3) << x;
}

TEST(PlaneCanvas, passes_over_triangles_and_lines_without_extent) {
  PlaneCanvas canvas(20, 20, 2);
  canvas.fill({Vec2{1, 1}, {10, 10}, {19, 19}}, flat(red));
  canvas.draw_mesh_lines(std::vector<Stroke>{{{5, 5}, {5, 5}, 3}}, black);
  EXPECT_EQ(darkness(canvas.picture()), 0);
}

}  // namespace
}  // namespace tetfarm
