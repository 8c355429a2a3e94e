#include <algorithm>
#include <array>
#include <numbers>
#include <utility>

#include "tests/support/cad_families.h"
#include "tests/support/relief.h"
#include "tests/support/revolved.h"
#include "tests/support/surface_parts.h"

namespace tetfarm::shapes {
namespace {

/// The rectangle that is left when `radius` rings go round it: the way along the outside, a quarter
/// of the ring at each corner.
Loop rounded_rectangle(const Loop& ring, GridPoint half, std::int64_t radius) {
  Loop loop;
  const std::size_t quarter = ring.size() / 4;
  const std::array<GridPoint, 4> corners = {
      GridPoint{half.x, half.y}, {-half.x, half.y}, {-half.x, -half.y}, {half.x, -half.y}};
  for (std::size_t c = 0; c < 4; ++c) {
    for (std::size_t k = 0; k <= quarter; ++k) {
      loop.push_back(corners[c] + radius * ring[(c * quarter + k) % ring.size()]);
    }
  }
  return loop;
}

/// A corner's arc of n sides between the directions of the two quarters, bulging out or in.
void add_arc(Loop& loop, GridPoint middle, std::int64_t radius, double first, double last, int n) {
  for (int k = 0; k <= n; ++k) {
    const double angle = std::numbers::pi / 2 * (first + (last - first) * k / n);
    const auto r = static_cast<double>(radius);
    loop.push_back(middle +
                   GridPoint{std::llround(r * std::cos(angle)), std::llround(r * std::sin(angle))});
  }
}

}  // namespace

SurfaceMesh rounded_block(std::uint64_t seed, int size) {
  Chance chance(seed);
  constexpr std::int64_t ring_radius = 1 << 14;
  const int sides = chance.pick_of({{{1, 2}, {1, 5}, {1, 10}, {1, 40}}}, size);
  const Loop ring = circle(4 * sides, ring_radius);
  const int steps = chance.pick_of({{{2, 2}, {2, 4}, {2, 12}, {2, 18}}}, size);
  const auto length = [&chance] { return std::int64_t{1} << chance.pick(10, 24); };
  const GridPoint half = {length(), length()};
  // Rows shrink by whole rings, and their heights run round a quarter of an ellipse.
  std::vector<RevolvedRow> rows = {{steps, 0}};
  const std::int64_t straight = length();
  const double rise = static_cast<double>(steps * ring_radius) * chance.small(-2, 0);
  for (int k = 0; k < steps; ++k) {
    const double share = static_cast<double>(k) / steps;
    rows.push_back({steps - k, straight + std::llround(rise * std::sqrt(share * (2 - share)))});
  }
  SurfaceMesh mesh;
  std::int32_t count = 0;
  for (const RevolvedRow& row : rows) {
    const Loop loop = rounded_rectangle(ring, half, row.radius);
    count = static_cast<std::int32_t>(loop.size());
    for (const GridPoint p : loop) {
      mesh.vertices.push_back(
          {static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(row.z)});
    }
  }
  const auto last = static_cast<std::int32_t>(rows.size() - 1) * count;
  for (std::int32_t low = 0; low < last; low += count) {
    for (std::int32_t k = 0; k < count; ++k) {
      const std::int32_t next = (k + 1) % count;
      add_quad(mesh, {low + k, low + next, low + count + next, low + count + k}, chance.coin());
    }
  }
  add_end_cap(mesh, 0, count, any_cap(chance), true);
  add_end_cap(mesh, last, count, any_cap(chance), false);
  return with_one_patch(std::move(mesh));
}

SurfaceMesh filleted_bar(std::uint64_t seed, int size) {
  Chance chance(seed);
  const int n = chance.pick_of({{{1, 3}, {2, 10}, {2, 60}, {2, 400}}}, size);
  const std::int64_t inner = 1 << chance.pick(10, 16);
  const std::int64_t outer = (1 << chance.pick(10, 16)) - 1;
  const std::int64_t wall = outer + chance.pick(1, 1 << 14);
  const std::int64_t far = wall + inner + chance.pick(1, 1 << 16);
  // The section of an angle, or of a channel with two.
  Loop loop = {{0, far}};
  add_arc(loop, {outer, outer}, outer, 2, 3, n);
  if (chance.coin()) {
    const std::int64_t width = 2 * far;
    add_arc(loop, {width - outer, outer}, outer, 3, 4, n);
    loop.insert(loop.end(), {{width, far}, {width - wall, far}});
    add_arc(loop, {width - wall - inner, wall + inner}, inner, 4, 3, n);
  } else {
    loop.insert(loop.end(), {{far, 0}, {far, wall}});
  }
  add_arc(loop, {wall + inner, wall + inner}, inner, 3, 2, n);
  loop.push_back({wall, far});
  Terrace bar;
  bar.outline = loop;
  bar.height = std::int64_t{1} << chance.pick(8, 26);
  ReliefOptions options;
  options.order = chance.coin() ? EarOrder::lowest : EarOrder::next;
  return relief(bar, options, chance);
}

}  // namespace tetfarm::shapes
