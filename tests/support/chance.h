/// Chance from a seed, for surfaces that are the same on every machine.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <random>

namespace tetfarm::shapes {

/// Numbers by chance from a seed. The standard's distributions differ between libraries; these do
/// not.
class Chance {
 public:
  explicit Chance(std::uint64_t seed) : random_(seed) {}
  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(random_() >> 11) / 9007199254740992.0;
  }
  /// From low to high, both included.
  int pick(int low, int high) {
    return low + static_cast<int>(random_() % static_cast<std::uint64_t>(high - low + 1));
  }
  /// Within the range of that number.
  int pick_of(const std::array<std::array<int, 2>, 4>& ranges, int number) {
    const auto& range = ranges[static_cast<std::size_t>(number)];
    return pick(range[0], range[1]);
  }
  bool coin() { return (random_() & 1024) != 0; }
  /// A small number of any order of size.
  double small(int lowest_power, int highest_power) {
    const double leading = between(0.2, 1);
    return leading * std::pow(10, pick(lowest_power, highest_power));
  }

 private:
  std::mt19937_64 random_;
};

}  // namespace tetfarm::shapes
