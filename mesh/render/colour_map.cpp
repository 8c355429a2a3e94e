#include "mesh/render/colour_map.h"

#include <algorithm>
#include <array>

#include "base/check.h"

namespace tetfarm {
namespace {

constexpr std::array<Colour, 11> steps = {{{0.183F, 0.089F, 0.465F},
                                           {0.134F, 0.205F, 0.558F},
                                           {0.004F, 0.322F, 0.585F},
                                           {0.009F, 0.421F, 0.584F},
                                           {0.020F, 0.513F, 0.605F},
                                           {0.008F, 0.607F, 0.622F},
                                           {0.002F, 0.704F, 0.617F},
                                           {0.222F, 0.796F, 0.561F},
                                           {0.523F, 0.857F, 0.498F},
                                           {0.762F, 0.906F, 0.447F},
                                           {0.981F, 0.944F, 0.437F}}};

}  // namespace

Colour map_colour(double share) {
  const double place = std::clamp(share, 0.0, 1.0) * (steps.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(place), steps.size() - 2);
  return mixed(steps[below], steps[below + 1],
               static_cast<float>(place - static_cast<double>(below)));
}

int FieldLevels::level_of(double value) const {
  TF_CHECK(low < high && count > 0);
  const double share = (value - low) / (high - low);
  return std::clamp(static_cast<int>(std::clamp(share, 0.0, 1.0) * count), 0, count - 1);
}

Colour FieldLevels::colour_of_level(int level) const {
  TF_CHECK(level >= 0 && level < count);
  return map_colour(count == 1 ? 0.5 : static_cast<double>(level) / (count - 1));
}

}  // namespace tetfarm
