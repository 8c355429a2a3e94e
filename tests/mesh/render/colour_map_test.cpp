#include "mesh/render/colour_map.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tetfarm {
namespace {

/// L* of CIE 1976, from the linear light of the colour's channels.
double lightness(const Colour& colour) {
  const auto linear = [](double level) {
    return level <= 0.04045 ? level / 12.92 : std::pow((level + 0.055) / 1.055, 2.4);
  };
  const double light =
      0.2126 * linear(colour.red) + 0.7152 * linear(colour.green) + 0.0722 * linear(colour.blue);
  return light > 0.008856 ? 116 * std::cbrt(light) - 16 : 903.3 * light;
}

TEST(ColourMap, grows_lighter_in_even_steps) {
  double before = lightness(map_colour(0));
  EXPECT_LT(before, 20);
  constexpr int steps = 200;
  for (int i = 1; i <= steps; ++i) {
    const double here = lightness(map_colour(static_cast<double>(i) / steps));
    EXPECT_GT(here - before, 0.2) << i;
    EXPECT_LT(here - before, 0.55) << i;
    before = here;
  }
  EXPECT_GT(before, 90);
}

TEST(ColourMap, has_the_colours_of_its_ends_beyond_them) {
  EXPECT_EQ(map_colour(-3), map_colour(0));
  EXPECT_EQ(map_colour(1e300), map_colour(1));
}

TEST(FieldLevels, never_fall_as_the_value_grows_and_are_of_one_height) {
  const FieldLevels levels{-2, 3, 10};
  for (int i = 0; i < 10; ++i) {
    EXPECT_EQ(levels.level_of(-2 + 0.5 * i + 0.001), i);
    EXPECT_EQ(levels.level_of(-2 + 0.5 * i + 0.499), i);
  }
  EXPECT_EQ(levels.level_of(-2), 0);
  EXPECT_EQ(levels.level_of(3), 9);
  EXPECT_EQ(levels.level_of(-1e300), 0);
  EXPECT_EQ(levels.level_of(1e300), 9);
}

TEST(FieldLevels, have_the_whole_map_and_grow_lighter) {
  const FieldLevels levels{0, 1, 7};
  EXPECT_EQ(levels.colour_of_level(0), map_colour(0));
  EXPECT_EQ(levels.colour_of_level(6), map_colour(1));
  for (int level = 1; level < 7; ++level) {
    EXPECT_GT(lightness(levels.colour_of_level(level)),
              lightness(levels.colour_of_level(level - 1)));
  }
  EXPECT_EQ((FieldLevels{0, 1, 1}.colour_at(0.9)), map_colour(0.5));
}

}  // namespace
}  // namespace tetfarm
