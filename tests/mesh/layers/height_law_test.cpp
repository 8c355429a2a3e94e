#include "mesh/layers/height_law.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tetfarm {
namespace {

TEST(HeightLaw, geometric_growth_has_the_closed_sum) {
  const HeightLaw law{.first = 1e-3, .growth = 1.2, .acceleration = 1, .cap = 1.2, .equal = 1};
  const double closed = 1e-3 * (std::pow(1.2, 20) - 1) / 0.2;
  EXPECT_NEAR(total_height(law, 20), closed, 1e-12 * closed);
  const std::vector<double> levels = levels_of(law, 20);
  ASSERT_EQ(levels.size(), 21U);
  EXPECT_EQ(levels[0], 0);
  EXPECT_EQ(levels[1], 1e-3);
  EXPECT_NEAR(levels[20], closed, 1e-12 * closed);
}

TEST(HeightLaw, equal_layers_come_first) {
  const HeightLaw law{.first = 1, .growth = 2, .acceleration = 1, .cap = 2, .equal = 3};
  EXPECT_EQ(levels_of(law, 5), (std::vector<double>{0, 1, 2, 3, 5, 9}));
}

TEST(HeightLaw, accelerated_growth_ends_at_its_cap) {
  const HeightLaw law{.first = 1, .growth = 2, .acceleration = 1.5, .cap = 4, .equal = 1};
  // 1, 1*2, 2*3, 6*4 (4.5 is above the cap), 24*4
  EXPECT_EQ(levels_of(law, 5), (std::vector<double>{0, 1, 3, 9, 33, 129}));
}

TEST(HeightLaw, layers_until_a_height_end_with_the_first_that_has_it) {
  const HeightLaw law{.first = 1, .growth = 2, .acceleration = 1, .cap = 2, .equal = 1};
  EXPECT_EQ(layers_until(law, 8, 100), 4);
  EXPECT_EQ(layers_until(law, 8.5, 100), 5);
  EXPECT_EQ(layers_until(law, 8, 3), 3);
  EXPECT_EQ(layers_until(law, 0.5, 100), 1);
}

TEST(HeightLaw, layers_within_a_height_end_with_the_first_that_reaches_it) {
  const HeightLaw law{.first = 1, .growth = 2, .acceleration = 1, .cap = 2, .equal = 1};
  EXPECT_EQ(layers_within(law, 7, 100), 3);
  EXPECT_EQ(layers_within(law, 7.5, 100), 4);
  EXPECT_EQ(layers_within(law, 0.5, 100), 1);
  EXPECT_EQ(layers_within(law, 1e9, 5), 5) << "no more than it may have";
}

TEST(HeightLaw, tells_how_high_one_layer_is) {
  const HeightLaw law{.first = 1, .growth = 2, .acceleration = 1, .cap = 2, .equal = 3};
  EXPECT_EQ(height_of_layer(law, 1), 1);
  EXPECT_EQ(height_of_layer(law, 3), 1);
  EXPECT_EQ(height_of_layer(law, 5), 4);
}

TEST(HeightLaw, fits_into_room_by_growing_less) {
  const HeightLaw law{.first = 1e-3, .growth = 1.2, .acceleration = 1, .cap = 1.2, .equal = 1};
  EXPECT_EQ(fitted(law, 20, 1), law);
  const HeightLaw lower = fitted(law, 20, 0.1);
  EXPECT_EQ(lower.first, law.first);
  EXPECT_LT(lower.growth, law.growth);
  EXPECT_LE(total_height(lower, 20), 0.1);
  EXPECT_GT(total_height(lower, 20), 0.1 * (1 - 1e-12));
  EXPECT_EQ(lower.share, 1) << "which is of lists";
}

TEST(HeightLaw, does_not_grow_where_even_equal_layers_do_not_fit) {
  const HeightLaw law{.first = 1, .growth = 1.2, .acceleration = 1.1, .cap = 1.5, .equal = 2};
  const HeightLaw even = fitted(law, 10, 5);
  EXPECT_EQ(total_height(even, 5), 5);
}

TEST(HeightLaw, of_a_list_has_its_heights_in_turn) {
  const std::vector<double> heights = {1, 1.5, 3, 1.5, 2};
  const HeightLaw law = law_of_heights(heights);
  EXPECT_EQ(levels_of(law, 5), (std::vector<double>{0, 1, 2.5, 5.5, 7, 9}));
  for (int i = 0; i < 5; ++i)
    EXPECT_EQ(height_of_layer(law, i + 1), heights.at(static_cast<std::size_t>(i)));
  EXPECT_EQ(total_height(law, 2), 2.5);
  EXPECT_EQ(law_of_heights(std::vector<double>{0.25}).first, 0.25);
  EXPECT_EQ(levels_of(law_of_heights(std::vector<double>{0.25}), 1),
            (std::vector<double>{0, 0.25}));
  EXPECT_EQ(levels_of(law, 0), std::vector<double>{0});
}

TEST(HeightLaw, of_a_list_has_no_layers_behind_its_end) {
  const HeightLaw law = law_of_heights(std::vector<double>{1, 2, 4});
  EXPECT_EQ(most_layers_of(law, 100), 3);
  EXPECT_EQ(most_layers_of(law, 2), 2);
  EXPECT_EQ(most_layers_of(HeightLaw{}, 100), 100);
  EXPECT_EQ(layers_until(law, 2, 100), 2);
  EXPECT_EQ(layers_until(law, 9, 100), 3);
  EXPECT_EQ(layers_within(law, 3.5, 100), 3);
  EXPECT_EQ(layers_within(law, 99, 100), 3);
}

TEST(HeightLaw, of_a_list_fits_into_room_by_growing_less_and_keeps_what_falls) {
  const HeightLaw law = law_of_heights(std::vector<double>{1, 2, 4, 2, 4});
  EXPECT_EQ(fitted(law, 5, 13), law);
  const HeightLaw lower = fitted(law, 5, 8);
  EXPECT_EQ(lower.first, 1);
  EXPECT_LE(total_height(lower, 5), 8);
  EXPECT_GT(total_height(lower, 5), 8 * (1 - 1e-12));
  const double ratio = height_of_layer(lower, 2);
  EXPECT_GT(ratio, 1);
  EXPECT_LT(ratio, 2);
  EXPECT_NEAR(height_of_layer(lower, 3), ratio * ratio, 1e-15);
  EXPECT_NEAR(height_of_layer(lower, 4), ratio * ratio / 2, 1e-15) << "half of the one before";
  EXPECT_EQ(levels_of(fitted(law, 5, 0.5), 5), (std::vector<double>{0, 1, 2, 3, 3.5, 4}));
}

TEST(HeightLaw, tells_how_high_layers_are_that_do_not_grow) {
  EXPECT_EQ(least_height(law_of_heights(std::vector<double>{1, 2, 1, 2}), 4), 3);
  EXPECT_EQ(least_height(HeightLaw{.first = 0.5, .growth = 1.5}, 3), 1.5);
}

TEST(HeightLaw, of_lists_is_the_same_where_the_numbers_are) {
  const std::vector<double> heights = {1, 2, 4};
  const HeightLaw law = law_of_heights(heights);
  EXPECT_EQ(law, law_of_heights(heights));
  EXPECT_NE(law, law_of_heights(std::vector<double>{1, 2, 3}));
  EXPECT_NE(law, law_of_heights(std::vector<double>{1, 2}));
  EXPECT_NE(law_of_heights(std::vector<double>{1}), HeightLaw{.first = 1}) << "which goes on";
}

}  // namespace
}  // namespace tetfarm
