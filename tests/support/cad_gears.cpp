#include <algorithm>
#include <array>
#include <numbers>

#include "tests/support/cad_families.h"
#include "tests/support/relief.h"

namespace tetfarm::shapes {
namespace {

constexpr std::int64_t tip_radius = std::int64_t{1} << 18;

GridPoint at_angle(double turns, double radius) {
  const double angle = 2 * std::numbers::pi * turns;
  return {std::llround(radius * std::cos(angle)), std::llround(radius * std::sin(angle))};
}

/// Root, flank up, tip, flank down: the angle always grows, so that the middle sees all.
Loop toothed_outline(int teeth, int flank_points, double root_radius) {
  Loop loop;
  const double rise = static_cast<double>(tip_radius) - root_radius;
  for (int tooth = 0; tooth < teeth; ++tooth) {
    for (int side = 0; side < 2; ++side) {
      for (int k = 0; k <= flank_points + 1; ++k) {
        const double share = static_cast<double>(k) / (flank_points + 1);
        const double turns = (tooth + 0.25 + 0.5 * side + 0.15 * share) / teeth;
        // A flank that is steepest at the root.
        const double height = side == 0 ? std::sqrt(share) : std::sqrt(1 - share);
        loop.push_back(at_angle(turns, root_radius + rise * height));
      }
    }
  }
  return loop;
}

/// A round hole with a slot on its side.
Loop bore_with_keyway(int n, std::int64_t radius) {
  const std::int64_t half = radius / 5;
  Loop loop = {{radius + half, -half}, {radius + half, half}};
  for (const GridPoint p : circle(n, radius)) {
    if (p.x < 0 || std::abs(p.y) > half) loop.push_back(p);
  }
  return loop;
}

}  // namespace

SurfaceMesh gear(std::uint64_t seed, int size) {
  Chance chance(seed);
  const int teeth = chance.pick_of({{{4, 6}, {6, 16}, {16, 80}, {80, 300}}}, size);
  const double root_radius = static_cast<double>(tip_radius) * (1 - chance.between(0.5, 2) / teeth);
  Terrace wheel;
  wheel.outline =
      toothed_outline(teeth, chance.pick(0, 2 * size), std::max(0.7 * tip_radius, root_radius));
  wheel.height = 16 + static_cast<std::int64_t>(chance.small(-2, 0) * tip_radius);
  const int round_corners = chance.pick(8, std::max(8, 20 * size));
  const std::int64_t bore_radius = tip_radius / chance.pick(8, 30);
  Terrace bore = {chance.coin() ? bore_with_keyway(round_corners, bore_radius)
                                : circle(round_corners, bore_radius),
                  0,
                  {}};
  if (chance.coin()) {
    const std::int64_t height = wheel.height + chance.pick(-15, 1000);
    wheel.inside.push_back({circle(round_corners, tip_radius / 4), height, {bore}});
  } else {
    wheel.inside.push_back(bore);
  }
  const int holes = size == 0 || chance.coin() ? 0 : chance.pick(3, 4 + 2 * size);
  for (int k = 0; k < holes; ++k) {
    const GridPoint middle = at_angle(static_cast<double>(k) / holes, 0.45 * tip_radius);
    wheel.inside.push_back({moved(circle(round_corners, tip_radius / (3 * holes)), middle), 0, {}});
  }
  ReliefOptions options;
  options.order = chance.coin() ? EarOrder::lowest : EarOrder::next;
  if (chance.coin()) options.most_raise = chance.pick(0, 20);
  return relief(wheel, options, chance);
}

}  // namespace tetfarm::shapes
