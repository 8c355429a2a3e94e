#include <algorithm>
#include <array>

#include "tests/support/cad_families.h"
#include "tests/support/relief.h"

namespace tetfarm::shapes {
namespace {

constexpr std::int64_t side = std::int64_t{1} << 20;

ReliefOptions any_options(Chance& chance, int most_splits) {
  ReliefOptions options;
  options.order = chance.coin() ? EarOrder::lowest : EarOrder::next;
  options.has_wall_fans = chance.coin();
  options.most_splits = most_splits;
  return options;
}

std::int64_t any_height(Chance& chance) {
  return 1 + static_cast<std::int64_t>(chance.small(-2, 0) * side);
}

/// Outlines inside each other, each a step up or down.
Terrace nested(Chance& chance, int levels) {
  Terrace whole;
  Terrace* here = &whole;
  const std::int64_t base = 2 * levels + any_height(chance);
  const int shape = chance.pick(0, 1), n = chance.pick(3, 24);
  for (int k = 0; k < levels; ++k) {
    const std::int64_t half = side - k * (side / (levels + 1));
    here->outline = shape == 0 ? rectangle({-half, -half}, {half, half}) : circle(n, half);
    here->height = base + chance.pick(-k, k);
    if (k + 1 < levels) {
      here->inside.emplace_back();
      here = &here->inside.front();
    }
  }
  return whole;
}

/// Seen from the side, stairs with treads a million times as long as they are high.
Terrace stairs(Chance& chance, int levels) {
  const std::int64_t run = side / levels;
  const std::int64_t base = any_height(chance);
  Terrace whole;
  whole.outline = {{0, 0}, {levels * run, 0}};
  for (int k = levels; k > 0; --k) {
    const std::int64_t height = base + levels - k + 1;
    whole.outline.push_back({k * run, height});
    whole.outline.push_back({(k - 1) * run, height});
  }
  whole.height = any_height(chance);
  return whole;
}

/// Pads on a plate, level with it or nearly so.
Terrace pads(Chance& chance, int count) {
  Terrace whole;
  whole.height = 8 + any_height(chance);
  const int columns = chance.pick(1, count);
  const int rows = (count + columns - 1) / columns;
  const std::int64_t cell = side / std::max(columns, rows);
  whole.outline = rectangle({0, 0}, {columns * cell, rows * cell});
  for (int k = 0; k < count; ++k) {
    const GridPoint corner = {(k % columns) * cell, (k / columns) * cell};
    const std::int64_t rim = 1 + cell / chance.pick(3, 1000);
    whole.inside.push_back(
        {rectangle(corner + GridPoint{rim, rim}, corner + GridPoint{cell - rim, cell - rim}),
         whole.height + chance.pick(-3, 3),
         {}});
  }
  return whole;
}

}  // namespace

SurfaceMesh split_extrusion(std::uint64_t seed, int size) {
  Chance chance(seed);
  const int n = chance.pick_of({{{3, 5}, {3, 8}, {3, 40}, {3, 60}}}, size);
  Terrace whole;
  switch (chance.pick(0, 2)) {
    case 0:
      whole.outline = rectangle({0, 0}, {side, any_height(chance)});
      break;
    case 1:
      whole.outline = circle(n, side);
      break;
    default:
      whole.outline = star_loop(n, side / 8, side, chance);
      break;
  }
  whole.height = any_height(chance);
  const int splits = chance.pick_of({{{1, 3}, {1, 8}, {1, 40}, {1, 60}}}, size);
  return relief(whole, any_options(chance, splits), chance);
}

SurfaceMesh fine_levels(std::uint64_t seed, int size) {
  Chance chance(seed);
  const int levels = chance.pick_of({{{2, 3}, {2, 7}, {2, 30}, {2, 200}}}, size);
  const int kind = chance.pick(0, 2);
  const Terrace whole = kind == 0   ? nested(chance, levels)
                        : kind == 1 ? stairs(chance, levels)
                                    : pads(chance, levels);
  return relief(whole,
                any_options(chance, chance.coin() ? 0 : chance.pick(1, std::max(1, 2 * size))),
                chance);
}

}  // namespace tetfarm::shapes
