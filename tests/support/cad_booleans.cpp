#include <algorithm>
#include <array>
#include <cstdlib>

#include "tests/support/cad_families.h"
#include "tests/support/merged_faces.h"
#include "tests/support/prism_grid.h"

namespace tetfarm::shapes {
namespace {

/// Lines far apart, and some next to each other.
GridLines uneven_lines(const std::array<int, 3>& sizes, Chance& chance) {
  GridLines lines;
  const int thin_in_8 = chance.pick(0, 4);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    lines[axis] = {0};
    for (int k = 0; k < sizes[axis]; ++k) {
      const bool is_thin = chance.pick(0, 7) < thin_in_8;
      lines[axis].push_back(lines[axis].back() + 2 * (is_thin ? 1 : chance.pick(200, 2000)));
    }
  }
  return lines;
}

struct Range {
  int low = 0;
  int high = 0;
  bool holds(int x, int unit) const { return unit * low <= x && x < unit * high; }
};

Range any_range(int size, Chance& chance) {
  const int a = chance.pick(0, size - 1), b = chance.pick(0, size - 1);
  return {std::min(a, b), std::max(a, b) + 1};
}

/// A box, or a prism that a slanting side or four cut off it.
void apply_any_tool(PrismGrid& grid, bool adds, Chance& chance) {
  const Range x = any_range(grid.size(0), chance), y = any_range(grid.size(1), chance),
              z = any_range(grid.size(2), chance);
  const int kind = chance.pick(0, 2);
  const int middle_x = 3 * (x.low + x.high), middle_y = 3 * (y.low + y.high);
  const int reach = 3 * std::max(x.high - x.low, y.high - y.low);
  const bool is_falling = chance.coin();
  grid.set(adds, [=](int x6, int y6, int layer) {
    if (!x.holds(x6, 6) || !y.holds(y6, 6) || !z.holds(layer, 1)) return false;
    const int dx = x6 - middle_x, dy = y6 - middle_y;
    if (kind == 1) return (is_falling ? dx + dy : dx - dy) < 0;
    if (kind == 2) return std::abs(dx) + std::abs(dy) < reach;
    return true;
  });
}

SurfaceMesh polygons_of(PrismGrid& grid, Chance& chance) {
  if (grid.is_empty()) grid.set(true, [](int, int, int) { return true; });
  grid.thicken_edges();
  MergeOptions options;
  options.order = chance.coin() ? EarOrder::lowest : EarOrder::next;
  options.kept_in_16 = chance.coin() ? 0 : chance.pick(1, 8);
  options.unmerged_in_16 = chance.coin() ? 0 : chance.pick(1, 8);
  return with_merged_faces(grid.surface(), options, chance);
}

}  // namespace

SurfaceMesh merged_voxels(std::uint64_t seed, int size) {
  Chance chance(seed);
  const int n = chance.pick_of({{{2, 3}, {2, 4}, {2, 8}, {2, 13}}}, size);
  std::vector<std::int64_t> line;
  for (int k = 0; k <= n; ++k) line.push_back(2 * k);
  PrismGrid grid({line, line, line});
  const int in_in_8 = chance.pick(2, 6);
  std::vector<bool> is_in;
  for (int k = 0; k < n * n * n; ++k) is_in.push_back(chance.pick(0, 7) < in_in_8);
  grid.set(true, [&](int x6, int y6, int z) {
    return static_cast<bool>(is_in[static_cast<std::size_t>((x6 / 6 * n + y6 / 6) * n + z)]);
  });
  return polygons_of(grid, chance);
}

SurfaceMesh box_boolean(std::uint64_t seed, int size) {
  Chance chance(seed);
  std::array<int, 3> sizes{};
  for (int& n : sizes) n = chance.pick_of({{{2, 3}, {2, 4}, {2, 8}, {2, 16}}}, size);
  PrismGrid grid(uneven_lines(sizes, chance));
  apply_any_tool(grid, true, chance);
  for (int k = chance.pick_of({{{1, 3}, {1, 5}, {1, 24}, {1, 36}}}, size); k > 0; --k) {
    const bool adds = chance.coin();
    apply_any_tool(grid, adds, chance);
  }
  return polygons_of(grid, chance);
}

}  // namespace tetfarm::shapes
