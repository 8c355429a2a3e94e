#include "mesh/layers/flat_plate.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tetfarm {
namespace {

TEST(FlatPlate, seventh_roots_have_the_number_as_their_seventh_power) {
  for (const double x : {1e-300, 1e-6, 0.5, 1.0, 2.0, 128.0, 6e6, 1e9, 1e12, 1e300}) {
    EXPECT_NEAR(std::pow(seventh_root(x), 7), x, 3e-15 * x) << x;
  }
  EXPECT_EQ(seventh_root(1), 1);
}

TEST(FlatPlate, first_height_is_what_wall_spacing_calculators_say) {
  // Re 6e6: 6e6^(1/7) = 9.29624, c_f = 0.00279683, u_tau / U = 0.0373954.
  const FlatPlate plate = flat_plate(1, 6e6, 1);
  EXPECT_NEAR(plate.skin_friction, 0.026 / std::pow(6e6, 1.0 / 7), 1e-15);
  EXPECT_NEAR(plate.first_height, 4.45688e-6, 1e-11);
  EXPECT_NEAR(plate.thickness, 0.0172113, 1e-7);
}

TEST(FlatPlate, first_height_has_the_y_plus_that_was_asked_for) {
  // y+ = y u_tau / nu, with nu = U L / Re.
  const FlatPlate plate = flat_plate(30, 1e7, 2.5);
  const double friction_velocity = std::sqrt(plate.skin_friction / 2);
  EXPECT_NEAR(plate.first_height * friction_velocity / (2.5 / 1e7), 30, 1e-12);
}

}  // namespace
}  // namespace tetfarm
