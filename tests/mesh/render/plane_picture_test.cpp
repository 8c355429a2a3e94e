#include "mesh/render/plane_picture.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "base/error.h"
#include "mesh/render/palette.h"

namespace tetfarm {
namespace {

using ::testing::HasSubstr;

/// The unit square of two triangles, each a region, with a patch for each side.
PlaneMesh square() {
  return {"square.mesh",
          {{0, 0}, {1, 0}, {1, 1}, {0, 1}},
          {{0, 1, 2}, {0, 2, 3}},
          {1, 2},
          {{0, 1}, {1, 2}, {2, 3}, {3, 0}},
          {1, 2, 3, 4},
          {},
          {},
          {}};
}

PlanePictureOptions small() {
  PlanePictureOptions options;
  options.width = 400;
  options.height = 300;
  options.edge_width = 0;
  return options;
}

/// Where a point of the plane is in the picture.
std::array<int, 3> colour_at(const Picture& picture, const PlaneFrame& frame, const Vec2& p) {
  const Vec2 q = frame.to_pixel(p);
  const auto i =
      static_cast<std::size_t>(3 * (static_cast<int>(q.y) * picture.width + static_cast<int>(q.x)));
  return {picture.bytes.at(i), picture.bytes.at(i + 1), picture.bytes.at(i + 2)};
}

std::array<int, 3> bytes_of(const Colour& colour) {
  const auto byte = [](float level) { return static_cast<int>(std::lround(255 * level)); };
  return {byte(colour.red), byte(colour.green), byte(colour.blue)};
}

void expect_same(const std::array<int, 3>& a, const std::array<int, 3>& b) {
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(a[i], b[i], 1);
}

constexpr PlaneBox unit_box{{0, 0}, {1, 1}};

TEST(PlanePicture, has_the_colour_of_the_field_inside_of_a_triangle) {
  const std::vector<double> field = {0, 2, 2, 0};  // 2 x
  const PlanePictureOptions options = small();
  const Picture picture = plane_picture(square(), {field, {}}, options);
  const PlaneFrame frame = plane_frame(unit_box, {}, 400, 300, Beside::colour_bar);
  const FieldLevels levels{0, 2, 20};
  for (int i = 0; i < 20; ++i) {
    const double x = 0.05 * i + 0.025;
    for (const double y : {0.21, 0.83}) {
      expect_same(colour_at(picture, frame, {x, y}), bytes_of(levels.colour_of_level(i)));
    }
  }
}

TEST(PlanePicture, shows_regions_and_patches_in_colours_of_their_own) {
  PlanePictureOptions options = small();
  options.width = 1200;
  options.height = 900;
  const Picture picture = plane_picture(square(), {}, options);
  const PlaneFrame frame = plane_frame(unit_box, {}, 1200, 900, Beside::legend);
  EXPECT_NE(colour_at(picture, frame, {0.7, 0.3}), colour_at(picture, frame, {0.3, 0.7}));
  expect_same(colour_at(picture, frame, {0.5, 0}), bytes_of(line_colour(0)));
  expect_same(colour_at(picture, frame, {0, 0.5}), bytes_of(line_colour(3)));
}

TEST(PlanePicture, has_the_same_bytes_twice_and_others_for_other_contents) {
  const std::vector<double> field = {0, 2, 2, 0};
  const std::vector<Metric2> metrics(4, metric_of_sizes({0.3, 0.1, 0.4}));
  const auto bytes = [&](const PlaneContents& contents) {
    return plane_picture(square(), contents, small()).bytes;
  };
  EXPECT_EQ(bytes({field, metrics}), bytes({field, metrics}));
  EXPECT_NE(bytes({field, metrics}), bytes({field, {}}));
  EXPECT_NE(bytes({field, metrics}), bytes({{}, metrics}));
}

TEST(PlanePicture, draws_the_ellipse_of_a_metric_true_to_scale) {
  PlaneMesh mesh = square();
  mesh.points.push_back({0.5, 0.5});
  mesh.triangles = {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
  mesh.regions = {1, 1, 1, 1};
  std::vector<Metric2> metrics(5, metric_of_sizes({1e-6, 1e-6, 0}));
  metrics[4] = metric_of_sizes({0.3, 0.1, 0});
  const Picture picture = plane_picture(mesh, {{}, metrics}, small());
  const PlaneFrame frame = plane_frame(unit_box, {}, 400, 300, Beside::nothing);
  const auto ground = colour_at(picture, frame, {0.5, 0.5});
  for (const Vec2& p : {Vec2{0.8, 0.5}, {0.2, 0.5}, {0.5, 0.6}, {0.5, 0.4}}) {
    EXPECT_LT(colour_at(picture, frame, p)[0], ground[0] - 30) << p.x << " " << p.y;
  }
  for (const Vec2& p : {Vec2{0.76, 0.5}, {0.84, 0.5}, {0.5, 0.56}, {0.5, 0.64}}) {
    expect_same(colour_at(picture, frame, p), ground);
  }
}

TEST(PlanePicture, zooms_to_the_width_and_the_centre_asked_for) {
  PlanePictureOptions options = small();
  options.window.across = 0.1;
  options.window.centre = Vec2{0.5, 0.5};
  const PlaneFrame frame = plane_frame(unit_box, options.window, 400, 300, Beside::nothing);
  EXPECT_NEAR(frame.high().x - frame.low.x, 0.1, 0.001);
  EXPECT_NEAR((frame.high().x + frame.low.x) / 2, 0.5, 1e-3);
  EXPECT_NEAR((frame.high().y + frame.low.y) / 2, 0.5, 1e-3);
  options.window = {2, {}, {}};
  const PlaneFrame twice = plane_frame(unit_box, options.window, 400, 300, Beside::nothing);
  const PlaneFrame once = plane_frame(unit_box, {}, 400, 300, Beside::nothing);
  EXPECT_NEAR(twice.pixels_per_unit / once.pixels_per_unit, 2, 0.02);
}

TEST(PlanePicture, draws_a_field_of_one_value_and_pictures_of_a_few_pixels) {
  const std::vector<double> field(4, 7);
  PlanePictureOptions options = small();
  EXPECT_EQ(plane_picture(square(), {field, {}}, options).width, 400);
  for (const int size : {1, 2, 30, 90}) {
    options.width = options.height = size;
    EXPECT_EQ(plane_picture(square(), {field, {}}, options).height, size);
  }
}

template <class Act>
std::string complaint(const Act& act) {
  try {
    act();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(PlanePicture, says_what_cannot_be_drawn) {
  PlaneMesh mesh = square();
  mesh.triangles[1][2] = 9;
  EXPECT_EQ(complaint([&] { plane_picture(mesh, {}, small()); }),
            "square.mesh: triangle 2 has node 10; there are 4");
  mesh = square();
  mesh.edges[3] = {3, -1};
  EXPECT_EQ(complaint([&] { plane_picture(mesh, {}, small()); }),
            "square.mesh: edge 4 has node 0; there are 4");
  const std::vector<double> field = {0, 2, 2, 0};
  PlanePictureOptions options = small();
  options.range = {2, 1};
  EXPECT_THAT(complaint([&] {
                plane_picture(square(), {field, {}}, options);
              }),
              HasSubstr("--range: the first number must be below the second"));
  const std::vector<double> far = {-1.7e308, 1.7e308, 0, 0};
  EXPECT_THAT(complaint([&] {
                plane_picture(square(), {far, {}}, small());
              }),
              HasSubstr("--field: the values are too far apart"));
  options = small();
  options.window.across = 1e-14;
  options.window.centre = Vec2{1, 1};
  EXPECT_THAT(complaint([&] { plane_picture(square(), {}, options); }), HasSubstr("--across"));
}

}  // namespace
}  // namespace tetfarm
