#include "mesh/spacing/exp_fixed.h"

#include <cmath>
#include <limits>

#include "base/check.h"

namespace tetfarm {
namespace {

// ln 2 in two parts; the first has 32 significant bits, so that k * ln2_high is exact.
constexpr double ln2_high = 0x1.62e42feep-1;
constexpr double ln2_low = 0x1.a39ef35793c76p-33;
constexpr double inverse_ln2 = 0x1.71547652b82fep+0;

}  // namespace

double exp_fixed(double x) {
  if (x < -700) return 0;
  if (x > 700) return std::numeric_limits<double>::infinity();
  const double k = std::floor(x * inverse_ln2 + 0.5);
  const double r = (x - k * ln2_high) - k * ln2_low;
  double sum = 1;
  for (int n = 14; n > 0; --n) sum = 1 + r / n * sum;
  return std::ldexp(sum, static_cast<int>(k));
}

double log_fixed(double x) {
  TF_CHECK(x >= std::numeric_limits<double>::min() && x <= std::numeric_limits<double>::max());
  int exponent = 0;
  double mantissa = std::frexp(x, &exponent);
  if (mantissa < 0x1.6a09e667f3bcdp-1) {
    mantissa *= 2;
    --exponent;
  }
  const double s = (mantissa - 1) / (mantissa + 1);
  const double s2 = s * s;
  double sum = 0;
  for (int n = 23; n >= 1; n -= 2) sum = 1.0 / n + s2 * sum;
  return exponent * ln2_high + (exponent * ln2_low + 2 * s * sum);
}

}  // namespace tetfarm
