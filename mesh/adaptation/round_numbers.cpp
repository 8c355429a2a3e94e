#include "mesh/adaptation/round_numbers.h"

#include "base/check.h"

namespace tetfarm {

std::array<double, 5> round_steps(double size) {
  TF_CHECK(size > 1e-60 && size < 1e60);
  // Powers of ten as such up to 1e22, and as reciprocals below 1: both exact there.
  int exponent = 0;
  while (size >= 10) {
    size /= 10;
    ++exponent;
  }
  while (size < 1) {
    size *= 10;
    --exponent;
  }
  std::array<double, 5> steps{};
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const int power = exponent - 2 - static_cast<int>(i);
    double factor = 1;
    for (int k = 0; k < std::abs(power); ++k) factor *= 10;
    steps[i] = power < 0 ? -factor : factor;
  }
  return steps;
}

}  // namespace tetfarm
