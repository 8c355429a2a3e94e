#include "mesh/spacing/lattice_planes.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"

namespace tetfarm {
namespace {

constexpr double inverse_sqrt2 = 0.70710678118654752;

struct Direction {
  std::size_t axis;
  std::size_t other_axis;
  std::int32_t sign;
};
constexpr std::array<Direction, 6> directions = {
    {{0, 1, 1}, {0, 1, -1}, {1, 2, 1}, {1, 2, -1}, {2, 0, 1}, {2, 0, -1}}};

Vec3 normal_of(const Direction& d) {
  Vec3 normal;
  normal[static_cast<int>(d.axis)] = inverse_sqrt2;
  normal[static_cast<int>(d.other_axis)] = d.sign * inverse_sqrt2;
  return normal;
}

/// The multiple of the largest power of two in [low, high].
/// @pre low <= high, and the two are far from the limits of the type.
std::int64_t coarsest_between(std::int64_t low, std::int64_t high) {
  TF_CHECK(low <= high);
  std::int64_t step = 1;
  const auto largest_multiple = [high](std::int64_t of) {
    return high >= 0 ? high - high % of : high - (of + high % of) % of;
  };
  while (step < octree_span && largest_multiple(2 * step) >= low) step *= 2;
  return largest_multiple(step);
}

}  // namespace

std::array<Vec3, 6> lattice_plane_normals() {
  std::array<Vec3, 6> normals;
  std::transform(directions.begin(), directions.end(), normals.begin(), normal_of);
  return normals;
}

std::optional<LatticePlane> coarsest_lattice_plane(const GridFrame& frame, std::size_t direction,
                                                   double least_offset, double largest_offset) {
  TF_CHECK(direction < directions.size());
  TF_CHECK(frame.unit > 0);
  const Direction& d = directions[direction];
  // The sum of the two coordinates, in half-units, of the grid's low corner.
  const std::int64_t origin = frame.low[d.axis] + d.sign * frame.low[d.other_axis];
  const double per_offset = 1 / (inverse_sqrt2 * frame.unit);
  const double low = std::fmax(-1.0 * octree_span,
                               std::ceil(least_offset * per_offset - static_cast<double>(origin)));
  const double high = std::fmin(
      2.0 * octree_span, std::floor(largest_offset * per_offset - static_cast<double>(origin)));
  if (!(low <= high)) return std::nullopt;
  const std::int64_t sum =
      coarsest_between(static_cast<std::int64_t>(low), static_cast<std::int64_t>(high));
  return LatticePlane{d.axis,       d.other_axis,
                      d.sign,       static_cast<std::int32_t>(sum),
                      normal_of(d), static_cast<double>(origin + sum) * frame.unit * inverse_sqrt2};
}

}  // namespace tetfarm
