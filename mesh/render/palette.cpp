#include "mesh/render/palette.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace tetfarm {
namespace {

/// Eight that were chosen by eye; more follow by formula.
constexpr std::array<Colour, 8> chosen = {{{0.49F, 0.68F, 0.87F},
                                           {0.97F, 0.73F, 0.42F},
                                           {0.58F, 0.79F, 0.50F},
                                           {0.90F, 0.53F, 0.51F},
                                           {0.70F, 0.61F, 0.85F},
                                           {0.95F, 0.88F, 0.48F},
                                           {0.47F, 0.80F, 0.77F},
                                           {0.91F, 0.64F, 0.80F}}};

/// A colour of the wheel, mixed with white.
Colour wheel_colour(double turn, float white) {
  const auto channel = [&](double offset) {
    const double x = 6 * (turn + offset - std::floor(turn + offset));
    const auto full = static_cast<float>(std::clamp(std::fabs(x - 3) - 1, 0.0, 1.0));
    return full + (1 - full) * white;
  };
  return {channel(0), channel(2.0 / 3), channel(1.0 / 3)};
}

}  // namespace

Colour palette_colour(std::int32_t number) {
  const auto i = static_cast<std::size_t>(std::max(number, 0));
  if (i < chosen.size()) return chosen[i];
  constexpr double golden = 0.6180339887498949;
  const auto white = 0.42F + 0.12F * static_cast<float>(i % 3);
  constexpr double first = 0.4;  // far from the last that was chosen
  return mixed(wheel_colour(first + golden * static_cast<double>(i), white), neutral_grey, 0.15F);
}

Colour line_colour(std::int32_t number) {
  constexpr std::array<Colour, 8> strong = {{{0.07F, 0.27F, 0.62F},
                                             {0.84F, 0.29F, 0.06F},
                                             {0.00F, 0.56F, 0.43F},
                                             {0.78F, 0.42F, 0.66F},
                                             {0.88F, 0.62F, 0.00F},
                                             {0.31F, 0.66F, 0.88F},
                                             {0.44F, 0.20F, 0.52F},
                                             {0.38F, 0.38F, 0.38F}}};
  return strong[static_cast<std::size_t>(std::max(number, 0)) % strong.size()];
}

Colour layer_colour(std::int32_t layer, bool is_absorbing) {
  constexpr std::array<Colour, 2> of_walls = {Colour{0.95F, 0.69F, 0.34F}, {0.99F, 0.86F, 0.62F}};
  constexpr std::array<Colour, 2> absorbing = {Colour{0.47F, 0.71F, 0.55F}, {0.73F, 0.88F, 0.76F}};
  return (is_absorbing ? absorbing : of_walls).at(layer % 2 == 0 ? 1 : 0);
}

}  // namespace tetfarm
