#include "mesh/adaptation/naca_profile.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tetfarm {
namespace {

double half_thickness(double x, double last) {
  return 0.6 * (0.2969 * std::sqrt(x) - 0.1260 * x - 0.3516 * x * x + 0.2843 * x * x * x -
                last * x * x * x * x);
}

TEST(NacaProfile, lies_on_the_formula) {
  for (const bool is_sharp : {true, false}) {
    NacaPlace place;
    place.is_sharp = is_sharp;
    const NacaProfile profile(place);
    for (int i = 0; i <= 3000; ++i) {
      const Vec2 p = profile.at(profile.length() * i / 3000);
      EXPECT_NEAR(std::abs(p.y), half_thickness(p.x, is_sharp ? 0.1036 : 0.1015), 2e-16) << p.x;
      EXPECT_EQ(p.y < 0, i < 1500 && p.y != 0) << i;
    }
  }
}

TEST(NacaProfile, closes_bit_by_bit_where_it_is_sharp) {
  NacaPlace place;
  place.nose = {0.3, 0.7};
  place.along = direction_of_angle(11);
  const NacaProfile sharp(place);
  EXPECT_EQ(sharp.at(0), sharp.at(sharp.length()));
  EXPECT_EQ(naca_parts(place).size(), 1U);
}

TEST(NacaProfile, has_a_straight_base_where_it_is_blunt) {
  NacaPlace place;
  place.is_sharp = false;
  const auto parts = naca_parts(place);
  ASSERT_EQ(parts.size(), 2U);
  EXPECT_NEAR(parts[1]->length(), 2 * 0.00126, 1e-15);
  EXPECT_EQ(parts[1]->at(0), parts[0]->at(parts[0]->length()));
  EXPECT_EQ(parts[1]->at(parts[1]->length()), parts[0]->at(0));
}

TEST(NacaProfile, finds_its_own_places_again) {
  NacaPlace place;
  place.along = direction_of_angle(-4);
  place.chord = 3;
  const NacaProfile profile(place);
  for (int i = 1; i < 997; ++i) {
    const double t = profile.length() * i / 997;
    EXPECT_NEAR(profile.nearest(profile.at(t)), t, 1e-13) << i;
  }
}

TEST(NacaProfile, goes_about_as_its_length_does) {
  const NacaProfile profile({});
  const double step = profile.length() / 500;
  for (int i = 0; i < 500; ++i) {
    const Vec2 p = profile.at(step * i);
    const Vec2 q = profile.at(step * (i + 1));
    EXPECT_NEAR(std::hypot(q.x - p.x, q.y - p.y) / step, 1, 0.02) << i;
  }
}

TEST(NacaProfile, is_placed_by_nose_chord_and_angle) {
  NacaPlace place;
  place.nose = {5, 6};
  place.chord = 2;
  place.along = direction_of_angle(90);
  const NacaProfile profile(place);
  EXPECT_EQ(profile.at(0), (Vec2{5, 8}));
  EXPECT_EQ(naca_text(place), "sharp trailing edge, chord 2 from (5, 6), angle 90");
  EXPECT_EQ(direction_of_angle(-90), (Vec2{0, -1}));
  EXPECT_EQ(direction_of_angle(360), (Vec2{1, 0}));
}

}  // namespace
}  // namespace tetfarm
