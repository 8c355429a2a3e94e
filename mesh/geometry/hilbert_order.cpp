#include "mesh/geometry/hilbert_order.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "base/check.h"

namespace tetfarm {
namespace {

constexpr int bits = 20;

/// Counter-based mixing (splitmix64), so that the round of a point needs no state.
std::uint64_t mixed(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15ULL;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
  return x ^ (x >> 31);
}

struct Key {
  std::uint64_t value;
  std::int32_t index;
};

/// Sorts by value, stably, digit by digit; digits that are the same in all keys are skipped.
std::vector<std::int32_t> sorted_indices(std::vector<Key>& keys) {
  constexpr unsigned digit_bits = 11;
  constexpr std::size_t digits = 1U << digit_bits;
  std::vector<Key> sorted(keys.size());
  for (unsigned shift = 0; shift < 64; shift += digit_bits) {
    std::array<std::uint32_t, digits> place{};
    const auto digit = [shift](const Key& key) { return key.value >> shift & (digits - 1); };
    for (const Key& key : keys) ++place[digit(key)];
    if (keys.empty() || place[digit(keys[0])] == keys.size()) continue;
    std::exclusive_scan(place.begin(), place.end(), place.begin(), 0U);
    for (const Key& key : keys) sorted[place[digit(key)]++] = key;
    keys.swap(sorted);
  }
  std::vector<std::int32_t> order(keys.size());
  std::transform(keys.begin(), keys.end(), order.begin(), [](const Key& k) { return k.index; });
  return order;
}

Box3 box_of(std::span<const Vec3> points) {
  Box3 box;
  for (const Vec3& p : points) box.add(p);
  return box;
}

/// The box's cells as small integers.
struct Grid {
  Vec3 low;
  double scale;

  explicit Grid(const Box3& box) : low(box.low) {
    const Vec3 size = box.size();
    const double edge = std::max({size.x, size.y, size.z});
    scale = edge > 0 ? (1 << bits) / edge : 0;
  }
  std::uint32_t cell(double coordinate, double low_coordinate) const {
    const double place = (coordinate - low_coordinate) * scale;
    return static_cast<std::uint32_t>(std::clamp(place, 0.0, (1 << bits) - 1.0));
  }
};

/// Two zero bits between each bit of x and the next.
std::uint64_t spread(std::uint64_t x) {
  x = (x | x << 32) & 0x1f00000000ffffULL;
  x = (x | x << 16) & 0x1f0000ff0000ffULL;
  x = (x | x << 8) & 0x100f00f00f00f00fULL;
  x = (x | x << 4) & 0x10c30c30c30c30c3ULL;
  return (x | x << 2) & 0x1249249249249249ULL;
}

/// Skilling's transform, with masks in place of branches: the bits are as good as random.
std::uint64_t index_on(const Grid& grid, const Vec3& point) {
  std::uint32_t x = grid.cell(point.x, grid.low.x);
  std::uint32_t y = grid.cell(point.y, grid.low.y);
  std::uint32_t z = grid.cell(point.z, grid.low.z);
  for (int bit = bits - 1; bit > 0; --bit) {
    const std::uint32_t p = (1U << bit) - 1;
    x ^= p & (0U - (x >> bit & 1));
    for (std::uint32_t* other : {&y, &z}) {
      const std::uint32_t is_set = 0U - (*other >> bit & 1);
      const std::uint32_t swapped = (x ^ *other) & p & ~is_set;
      x ^= swapped | (p & is_set);
      *other ^= swapped;
    }
  }
  y ^= x;
  z ^= y;
  std::uint32_t t = 0;
  for (int bit = bits - 1; bit > 0; --bit) t ^= ((1U << bit) - 1) & (0U - (z >> bit & 1));
  return spread(x ^ t) << 2 | spread(y ^ t) << 1 | spread(z ^ t);
}

}  // namespace

std::uint64_t hilbert_index(const Vec3& point, const Box3& box) {
  return index_on(Grid(box), point);
}

std::vector<std::int32_t> hilbert_order(std::span<const Vec3> points) {
  const Grid grid(box_of(points));
  std::vector<Key> keys(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    keys[i] = {index_on(grid, points[i]), static_cast<std::int32_t>(i)};
  }
  return sorted_indices(keys);
}

std::vector<std::int32_t> hilbert_order(std::size_t count,
                                        const std::function<Vec3(std::size_t)>& place) {
  Box3 box;
  for (std::size_t i = 0; i < count; ++i) box.add(place(i));
  const Grid grid(box);
  std::vector<Key> keys(count);
  for (std::size_t i = 0; i < count; ++i) {
    keys[i] = {index_on(grid, place(i)), static_cast<std::int32_t>(i)};
  }
  return sorted_indices(keys);
}

std::vector<std::int32_t> brio_order(std::span<const Vec3> points) {
  TF_CHECK(points.size() <= std::numeric_limits<std::int32_t>::max());
  const Grid grid(box_of(points));
  int rounds = 0;
  for (std::size_t n = points.size(); n > 1000; n /= 8) ++rounds;
  TF_CHECK(rounds < 16);  // four bits above those of the place on the curve
  std::vector<Key> keys(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    std::uint64_t dice = mixed(i);
    std::uint64_t round = static_cast<std::uint64_t>(rounds);
    for (; round > 0 && (dice & 7) == 0; dice >>= 3) --round;
    keys[i] = {round << 60 | index_on(grid, points[i]), static_cast<std::int32_t>(i)};
  }
  return sorted_indices(keys);
}

}  // namespace tetfarm
