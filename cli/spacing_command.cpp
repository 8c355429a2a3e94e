#include <cstdio>
#include <nlohmann/json.hpp>

#include "cli/commands.h"
#include "json/json_line.h"
#include "mesh/layers/flat_plate.h"

namespace tetfarm {

ExitCode spacing_command(const SpacingCommand& command) {
  const FlatPlate plate = flat_plate(command.y_plus, command.reynolds, command.length);
  if (command.json) {
    const nlohmann::ordered_json json = {{"type", "spacing"},
                                         {"first_height", plate.first_height},
                                         {"skin_friction", plate.skin_friction},
                                         {"boundary_layer", plate.thickness}};
    std::printf("%s\n", json_line(json).c_str());
    return ExitCode::ok;
  }
  std::printf("first height    %.4g, for y+ = %g at the first node off the wall\n",
              plate.first_height, command.y_plus);
  std::printf("skin friction   %.4g\nboundary layer  %.4g thick\n", plate.skin_friction,
              plate.thickness);
  return ExitCode::ok;
}

}  // namespace tetfarm
