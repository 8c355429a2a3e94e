// Views, colours and light: worked out for a square that fills a known share of the picture.
#include <gtest/gtest.h>

#include <cmath>

#include "base/error.h"
#include "mesh/render/camera.h"
#include "mesh/render/palette.h"
#include "mesh/render/render_mesh.h"

namespace tetfarm {
namespace {

/// A square in the plane z = 0 of two boundary triangles on a flat tet each below it, at x from
/// `left` on.
NumberedPart square(std::int32_t number, double left, std::int32_t patch) {
  NumberedPart part;
  part.number = number;
  part.region = number + 1;
  part.nodes = {
      {left, 0, 0}, {left + 1, 0, 0}, {left + 1, 1, 0}, {left, 1, 0}, {left + 0.5, 0.5, -0.1}};
  part.local2global = {0, 1, 2, 3, 4};
  part.tets = {{0, 2, 1, 4}, {0, 3, 2, 4}};
  part.faces = {{0, 1, 2}, {0, 2, 3}};
  part.patch_of_face = {patch, patch};
  return part;
}

RenderOptions from_above() {
  RenderOptions options;
  options.width = 100;
  options.height = 50;
  options.samples = 1;
  options.edge_width = 0;
  options.camera.from = {0, 0, 1};
  options.camera.up = {0, 1, 0};
  return options;
}

Picture picture_of(std::vector<NumberedPart> parts, const RenderOptions& options,
                   const std::vector<std::string>& patches = {"a", "b"}) {
  return render_mesh(
      [&parts](const auto& visit) {
        for (NumberedPart& part : parts) visit(part);
      },
      patches, options);
}

std::array<int, 3> pixel_at(const Picture& picture, int x, int y) {
  const auto i = static_cast<std::size_t>(3 * (y * picture.width + x));
  return {picture.bytes.at(i), picture.bytes.at(i + 1), picture.bytes.at(i + 2)};
}

/// A colour as it looks with its face towards the eye.
std::array<int, 3> facing(const Colour& colour) {
  // The light comes from -0.45 right, 0.75 up and 1 back: to the eye it is 1 of its length.
  const double key = 1 / std::sqrt(0.45 * 0.45 + 0.75 * 0.75 + 1);
  const double light = 0.50 + 0.36 * key + 0.24;
  const auto byte = [light](float level) {
    return static_cast<int>(std::lround(255 * std::min(1.0, level * light)));
  };
  return {byte(colour.red), byte(colour.green), byte(colour.blue)};
}

constexpr std::array<int, 3> white = {255, 255, 255};

void expect_near(const std::array<int, 3>& a, const std::array<int, 3>& b) {
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(a[i], b[i], 1) << i;
}

TEST(WholePictures, show_parts_by_the_colour_of_what_is_asked_for) {
  const std::vector<NumberedPart> parts = {square(0, 0, 1), square(1, 1, 0)};
  RenderOptions options = from_above();
  const auto left_and_right = [&](const Colour& left, const Colour& right) {
    const Picture picture = picture_of(parts, options);
    expect_near(pixel_at(picture, 30, 25), facing(left));
    expect_near(pixel_at(picture, 70, 25), facing(right));
  };
  left_and_right(palette_colour(0), palette_colour(1));
  options.colour_by = ColourBy::patch;
  left_and_right(palette_colour(1), palette_colour(0));
  options.colour_by = ColourBy::region;
  left_and_right(palette_colour(0), palette_colour(1));
  options.view = View::exploded;
  options.colour_by = ColourBy::patch;
  left_and_right(palette_colour(1), palette_colour(0));
}

TEST(WholePictures, fill_the_picture_but_for_a_margin) {
  const Picture picture = picture_of({square(0, 0, 0), square(1, 1, 0)}, from_above());
  // 2 x 1 on 100 x 50 with a margin of 4 hundredths: from 4 to 96, and from 2 to 48.
  for (const auto& [x, y] : {std::pair{5, 25}, {94, 25}, {50, 3}, {50, 46}}) {
    EXPECT_NE(pixel_at(picture, x, y), white) << x << " " << y;
  }
  for (const auto& [x, y] : {std::pair{2, 25}, {97, 25}, {50, 0}, {50, 49}}) {
    EXPECT_EQ(pixel_at(picture, x, y), white) << x << " " << y;
  }
}

TEST(WholePictures, hide_patches_and_look_at_bodies) {
  RenderOptions options = from_above();
  options.hidden = {"b"};
  const std::vector<NumberedPart> parts = {square(0, 0, 0), square(1, 1, 1)};
  const Picture hidden = picture_of(parts, options);
  EXPECT_NE(pixel_at(hidden, 30, 25), white);
  EXPECT_EQ(pixel_at(hidden, 70, 25), white);
  options.hidden.clear();
  options.bodies = {"b"};
  const Picture body = picture_of(parts, options);
  expect_near(pixel_at(body, 50, 25), facing(palette_colour(1)));
  EXPECT_EQ(pixel_at(body, 20, 25), white) << "it looks at the body alone";
  options.view = View::cut;
  options.cut_normal = {0, 0, 1};
  options.cut_at = 1;
  const Picture cut = picture_of(parts, options);
  expect_near(pixel_at(cut, 50, 25), facing(neutral_grey));
  expect_near(pixel_at(cut, 5, 25), facing(palette_colour(0)));
  // The body is widened by 0.12 of its diagonal on each side: 46 / (1 + 0.24 sqrt 2) pixels.
  expect_near(pixel_at(cut, 36, 30), facing(neutral_grey));
  expect_near(pixel_at(cut, 29, 30), facing(palette_colour(0)));
}

TEST(WholePictures, cut_at_the_middle_where_nothing_else_is_said) {
  RenderOptions options = from_above();
  options.view = View::cut;
  options.cut_normal = {1, 0, 0};
  options.camera.from = {0.001, 0, 1};
  const Picture picture = picture_of({square(0, 0, 0), square(1, 1, 0)}, options);
  EXPECT_NE(pixel_at(picture, 30, 25), white);
  EXPECT_EQ(pixel_at(picture, 70, 25), white) << "what is before the plane is gone";
  options.cut_normal = {-1, 0, 0};
  EXPECT_EQ(picture_of({square(0, 0, 0), square(1, 1, 0)}, options).bytes, picture.bytes)
      << "whichever way the normal points";
}

TEST(WholePictures, move_parts_apart_as_far_as_asked_for) {
  RenderOptions options = from_above();
  options.view = View::exploded;
  options.explosion = 1;
  const Picture picture = picture_of({square(0, 0, 0), square(1, 1, 0)}, options);
  // Each moves by half a side: 3 sides across, the middle one empty.
  EXPECT_NE(pixel_at(picture, 20, 25), white);
  EXPECT_EQ(pixel_at(picture, 50, 25), white);
  EXPECT_NE(pixel_at(picture, 80, 25), white);
}

std::string said(const std::vector<NumberedPart>& parts, const RenderOptions& options) {
  try {
    picture_of(parts, options);
  } catch (const UsageError& error) {
    return error.what();
  }
  return "";
}

TEST(WholePictures, say_what_there_is_not_to_be_seen) {
  RenderOptions options = from_above();
  EXPECT_EQ(said({}, options), "render: there is nothing to draw");
  EXPECT_EQ(said({NumberedPart{}}, options), "render: there is nothing to draw");
  options.bodies = {"c"};
  EXPECT_EQ(said({square(0, 0, 0)}, options), "--body: no patch \"c\"; the patches are a, b");
  options.bodies = {"b"};
  EXPECT_EQ(said({square(0, 0, 0)}, options), "--body: no triangle belongs to these patches");
  options.view = View::exploded;
  EXPECT_EQ(said({square(0, 0, 0)}, options), "") << "all is shown";
  options.bodies.clear();
  options.hidden = {"c"};
  EXPECT_EQ(said({square(0, 0, 0)}, options), "--hide: no patch \"c\"; the patches are a, b");
}

TEST(WholePictures, draw_edges_and_outlines_darker) {
  RenderOptions options = from_above();
  options.edge_width = 2;
  const std::vector<NumberedPart> parts = {square(0, 0, 0), square(1, 1, 0)};
  const Picture picture = picture_of(parts, options);
  EXPECT_LT(pixel_at(picture, 49, 20)[2], facing(palette_colour(0))[2] / 2)
      << "between the squares";
  expect_near(pixel_at(picture, 35, 40), facing(palette_colour(0)));
}

TEST(PaletteColours, are_those_that_were_chosen_and_then_go_round_the_wheel) {
  EXPECT_EQ(palette_colour(0), (Colour{0.49F, 0.68F, 0.87F}));
  EXPECT_EQ(palette_colour(7), (Colour{0.91F, 0.64F, 0.80F}));
  EXPECT_EQ(palette_colour(-5), palette_colour(0));
  // Turn 0.4 + 8 * 0.618… = 5.344…: 0.344 of the wheel, green, with 0.42 + 0.24 white.
  const Colour eighth = palette_colour(8);
  EXPECT_NEAR(eighth.red, 0.66 * 0.85 + 0.78 * 0.15, 1e-5);
  EXPECT_NEAR(eighth.green, 1 * 0.85 + 0.79 * 0.15, 1e-5);
  const double turn = 0.4 + 8 * 0.6180339887498949 - 5;
  const double blue = 6 * turn - 2;  // the rest of the way from green to cyan
  EXPECT_NEAR(eighth.blue, (blue + (1 - blue) * 0.66) * 0.85 + 0.81 * 0.15, 1e-5);
}

TEST(CameraOf, a_unit_square_sees_it_from_twice_as_far_as_it_is_wide) {
  Box3 box{{0, 0, 0}, {1, 1, 0}};
  const std::array<Vec3, 4> corners = {Vec3{0, 0, 0}, Vec3{1, 0, 0}, Vec3{1, 1, 0}, Vec3{0, 1, 0}};
  const Camera camera(box, corners, {{0, 0, 2}, {0, 1, 0}, 1, {}, {}}, 200, 100);
  // A quarter is the tangent of half the angle of view: four radii, of half a diagonal each.
  EXPECT_NEAR(camera.eye().z, 4 * std::sqrt(0.5), 1e-12);
  const Seen middle = camera.project({0.5, 0.5, 0});
  EXPECT_NEAR(middle.x, 100, 1e-9);
  EXPECT_NEAR(middle.y, 50, 1e-9);
  EXPECT_NEAR(middle.depth, camera.eye().z, 1e-12);
  const Seen corner = camera.project({0, 1, 0});
  EXPECT_NEAR(corner.x, 100 - 46, 1e-9);
  EXPECT_NEAR(corner.y, 4, 1e-9);
  EXPECT_EQ(camera.axes().ahead, (Vec3{0, 0, -1}));
  EXPECT_EQ(camera.axes().right, (Vec3{1, 0, 0}));
  EXPECT_EQ(camera.axes().up, (Vec3{0, 1, 0}));
}

TEST(CameraOf, a_point_among_much_else_stays_outside_of_that) {
  const Box3 all{{-10, -10, -10}, {10, 10, 10}};
  const std::array<Vec3, 2> focus = {Vec3{0, 0, 0}, Vec3{0.1, 0, 0}};
  const Camera camera(all, focus, {{0, 0, 1}, {0, 1, 0}, 1, {}, {}}, 100, 100);
  EXPECT_NEAR(camera.eye().z, 0.1 * 0.05 + 1.1 * 10, 1e-12);
}

TEST(WholePictures, light_faces_from_either_side) {
  NumberedPart part = square(0, 0, 0);
  const Picture picture = picture_of({part}, from_above());
  for (Triangle& face : part.faces) std::swap(face[1], face[2]);
  EXPECT_EQ(picture_of({part}, from_above()).bytes, picture.bytes);
}

TEST(WholePictures, outline_steps_of_more_than_a_fiftieth_of_the_mesh) {
  const auto darkest_where_they_meet = [](double step) {
    NumberedPart lower = square(1, 1, 0);
    for (Vec3& p : lower.nodes) p.z -= step;
    const Picture picture = picture_of({square(0, 0, 0), lower}, from_above());
    int darkest = 255;
    for (int x = 45; x < 55; ++x) darkest = std::min(darkest, pixel_at(picture, x, 20)[0]);
    return darkest;
  };
  const int plain = darkest_where_they_meet(0);
  EXPECT_EQ(darkest_where_they_meet(0.02), plain);
  EXPECT_LT(darkest_where_they_meet(0.06), plain * 3 / 4);
}

}  // namespace
}  // namespace tetfarm
