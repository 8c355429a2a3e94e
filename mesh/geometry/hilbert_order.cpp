#include "mesh/geometry/hilbert_order.h"

#include <algorithm>
#include <array>
#include <numeric>

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
  friend bool operator<(const Key& a, const Key& b) {
    return a.value != b.value ? a.value < b.value : a.index < b.index;
  }
};

std::vector<std::int32_t> sorted_indices(std::vector<Key>& keys) {
  std::sort(keys.begin(), keys.end());
  std::vector<std::int32_t> order(keys.size());
  std::transform(keys.begin(), keys.end(), order.begin(), [](const Key& k) { return k.index; });
  return order;
}

Box3 box_of(std::span<const Vec3> points) {
  Box3 box;
  for (const Vec3& p : points) box.add(p);
  return box;
}

}  // namespace

std::uint64_t hilbert_index(const Vec3& point, const Box3& box) {
  const Vec3 size = box.size();
  const double edge = std::max({size.x, size.y, size.z});
  const double scale = edge > 0 ? (1 << bits) / edge : 0;
  std::array<std::uint32_t, 3> x{};
  for (int axis = 0; axis < 3; ++axis) {
    const double cell = (point[axis] - box.low[axis]) * scale;
    x[static_cast<std::size_t>(axis)] =
        static_cast<std::uint32_t>(std::clamp(cell, 0.0, (1 << bits) - 1.0));
  }
  for (std::uint32_t q = 1U << (bits - 1); q > 1; q >>= 1) {
    const std::uint32_t p = q - 1;
    for (std::uint32_t& coordinate : x) {
      if ((coordinate & q) != 0) {
        x[0] ^= p;
      } else {
        const std::uint32_t t = (x[0] ^ coordinate) & p;
        x[0] ^= t;
        coordinate ^= t;
      }
    }
  }
  x[1] ^= x[0];
  x[2] ^= x[1];
  std::uint32_t t = 0;
  for (std::uint32_t q = 1U << (bits - 1); q > 1; q >>= 1) {
    if ((x[2] & q) != 0) t ^= q - 1;
  }
  std::uint64_t index = 0;
  for (std::uint32_t& coordinate : x) coordinate ^= t;
  for (int bit = bits - 1; bit >= 0; --bit) {
    for (const std::uint32_t coordinate : x) index = index << 1 | (coordinate >> bit & 1);
  }
  return index;
}

std::vector<std::int32_t> hilbert_order(std::span<const Vec3> points) {
  const Box3 box = box_of(points);
  std::vector<Key> keys(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    keys[i] = {hilbert_index(points[i], box), static_cast<std::int32_t>(i)};
  }
  return sorted_indices(keys);
}

std::vector<std::int32_t> brio_order(std::span<const Vec3> points) {
  const Box3 box = box_of(points);
  int rounds = 0;
  for (std::size_t n = points.size(); n > 1000; n /= 8) ++rounds;
  std::vector<Key> keys(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    std::uint64_t dice = mixed(i);
    std::uint64_t round = static_cast<std::uint64_t>(rounds);
    for (; round > 0 && (dice & 7) == 0; dice >>= 3) --round;
    keys[i] = {round << 60 | hilbert_index(points[i], box), static_cast<std::int32_t>(i)};
  }
  return sorted_indices(keys);
}

}  // namespace tetfarm
