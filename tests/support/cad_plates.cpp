#include <algorithm>
#include <array>

#include "tests/support/cad_families.h"
#include "tests/support/relief.h"

namespace tetfarm::shapes {
namespace {

constexpr std::int64_t cell = 1024;

/// A square, a slot, a star or a polygon round the origin, 500 from it at most.
Loop hole_outline(Chance& chance, int most_corners) {
  const std::int64_t most = chance.pick(130, 500);
  switch (chance.pick(0, 3)) {
    case 0:
      return rectangle({-most, -most}, {most, most});
    case 1: {
      const std::int64_t half = chance.pick(1, 100);
      return rectangle({-most, -half}, {most, half});
    }
    case 2:
      return star_loop(chance.pick(3, most_corners), 100, most, chance);
    default:
      return star_loop(chance.pick(3, most_corners), most, most, chance);
  }
}

}  // namespace

SurfaceMesh perforated_plate(std::uint64_t seed, int size) {
  Chance chance(seed);
  const int holes = chance.pick_of({{{1, 3}, {1, 9}, {9, 80}, {80, 1000}}}, size);
  const int columns = std::max(1, static_cast<int>(std::sqrt(holes * chance.between(0.3, 1))));
  const int rows = (holes + columns - 1) / columns;
  const int most_corners = chance.pick(4, size == 0 ? 6 : 20);
  const bool are_alike = chance.coin();
  const Loop pattern = hole_outline(chance, most_corners);
  const double thickness = chance.small(-2, 0) * static_cast<double>(cell);
  Terrace plate;
  plate.height = 4 + static_cast<std::int64_t>(thickness);
  plate.outline = rectangle({0, 0}, {columns * cell, rows * cell});
  const int least_through = chance.pick(0, 3);
  for (int k = 0; k < holes; ++k) {
    const GridPoint middle = {(k % columns) * cell + cell / 2, (k / columns) * cell + cell / 2};
    Terrace hole;
    hole.outline = moved(are_alike ? pattern : hole_outline(chance, most_corners), middle);
    const bool is_through = chance.pick(0, 3) >= least_through;
    hole.height = is_through ? 0 : chance.pick(1, static_cast<int>(plate.height) - 1);
    plate.inside.push_back(std::move(hole));
  }
  ReliefOptions options;
  options.order = chance.coin() ? EarOrder::lowest : EarOrder::next;
  // Blind holes are at least 1 deep, 64 units.
  if (chance.pick(0, 3) == 0)
    options.most_raise = chance.pick(1, 30);
  else
    options.most_splits = chance.coin() ? 0 : chance.pick(1, std::max(1, 2 * size));
  return relief(plate, options, chance);
}

}  // namespace tetfarm::shapes
