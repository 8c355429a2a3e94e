#include <algorithm>
#include <utility>

#include "tests/support/cad_families.h"
#include "tests/support/relief.h"
#include "tests/support/revolved.h"
#include "tests/support/surface_parts.h"

namespace tetfarm::shapes {
namespace {

constexpr std::int64_t ring_radius = std::int64_t{1} << 20;

std::int64_t whole_length(Chance& chance, int lowest_power, int highest_power) {
  const double length = chance.small(lowest_power, highest_power);
  return std::max<std::int64_t>(1, std::llround(length * ring_radius));
}

/// A tip over every side of an outline that sees its middle.
SurfaceMesh pyramid(const Loop& outline, std::int64_t height, EarOrder order) {
  SurfaceMesh mesh;
  for (const GridPoint p : outline) {
    mesh.vertices.push_back({static_cast<double>(p.x), static_cast<double>(p.y), 0});
  }
  mesh.vertices.push_back({0, 0, static_cast<double>(height)});
  const auto n = static_cast<std::int32_t>(outline.size());
  for (std::int32_t k = 0; k < n; ++k) mesh.triangles.push_back({k, (k + 1) % n, n});
  for (const auto& [a, b, c] : clip_ears({outline}, order)) mesh.triangles.push_back({a, c, b});
  return with_one_patch(std::move(mesh));
}

}  // namespace

SurfaceMesh capped_cylinder(std::uint64_t seed, int size) {
  Chance chance(seed);
  const int sides = chance.pick_of({{{4, 14}, {5, 40}, {40, 160}, {160, 500}}}, size);
  const Loop ring = circle(sides, ring_radius);
  std::vector<RevolvedRow> rows = {{chance.pick(1, 8), 0}};
  if (chance.pick(0, 5) == 0) rows.front().radius = 0;
  for (int k = chance.pick(1, std::max(1, 2 * size)); k > 0; --k) {
    const RevolvedRow last = rows.back();
    const bool is_shoulder = last.radius > 0 && rows.size() > 1 && chance.coin();
    const std::int64_t radius = last.radius > 0 && chance.coin() ? last.radius : chance.pick(1, 8);
    if (is_shoulder && radius != last.radius) {
      rows.push_back({radius, last.z});
    }
    rows.push_back({is_shoulder ? radius : std::int64_t{chance.pick(1, 8)},
                    last.z + whole_length(chance, -3, 1)});
  }
  if (chance.pick(0, 5) == 0) rows.push_back({0, rows.back().z + whole_length(chance, -2, 1)});
  return revolved(ring, rows, any_cap(chance), chance);
}

SurfaceMesh fan_node(std::uint64_t seed, int size) {
  Chance chance(seed);
  const int n = chance.pick_of({{{6, 20}, {20, 120}, {120, 500}, {500, 2000}}}, size);
  const EarOrder order = chance.coin() ? EarOrder::lowest : EarOrder::next;
  const std::int64_t height = whole_length(chance, -3, 1);
  switch (chance.pick(0, 3)) {
    case 0:
      return pyramid(circle(n, 4 * ring_radius), height, order);
    case 1:
      return pyramid(star_loop(n, ring_radius, 2 * ring_radius, chance), height, order);
    case 2: {
      const std::array<RevolvedRow, 2> rows = {RevolvedRow{1, 0}, RevolvedRow{1, height}};
      return revolved(circle(n, 4 * ring_radius), rows, EndCap::middle_fan, chance);
    }
    default: {
      const std::int64_t half = 1 + ring_radius / chance.pick(2, 1000);
      const Terrace hole = {rectangle({-half, -half}, {half, half}), 0, {}};
      return relief({circle(n, 2 * ring_radius), height, {hole}}, {.order = order}, chance);
    }
  }
}

}  // namespace tetfarm::shapes
