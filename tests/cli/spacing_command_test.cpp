// What `spacing` says, called as main calls it.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "cli/commands.h"
#include "mesh/layers/flat_plate.h"
#include "tests/cli/said.h"

namespace tetfarm {
namespace {

TEST(SpacingOfAPlate, is_told_to_people_in_three_lines) {
  const SpacingCommand command{.y_plus = 1, .reynolds = 6e6, .length = 1, .json = false};
  const Said said = said_by([&] { return spacing_command(command); });
  EXPECT_EQ(said.code, ExitCode::ok);
  EXPECT_EQ(said.out,
            "first height    4.457e-06, for y+ = 1 at the first node off the wall\n"
            "skin friction   0.002797\nboundary layer  0.01721 thick\n");
}

TEST(SpacingOfAPlate, is_told_to_programs_with_all_digits) {
  const SpacingCommand command{.y_plus = 30, .reynolds = 1e7, .length = 2.5, .json = true};
  const Said said = said_by([&] { return spacing_command(command); });
  const auto json = nlohmann::json::parse(said.out);
  const FlatPlate plate = flat_plate(30, 1e7, 2.5);
  EXPECT_EQ(json["type"], "spacing");
  EXPECT_EQ(json["first_height"], plate.first_height);
  EXPECT_EQ(json["skin_friction"], plate.skin_friction);
  EXPECT_EQ(json["boundary_layer"], plate.thickness);
}

}  // namespace
}  // namespace tetfarm
