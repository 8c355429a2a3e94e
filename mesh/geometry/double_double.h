/// Numbers as unevaluated sums of two doubles, some 106 bits: enough for nearly all determinants
/// that plain doubles leave undecided, at a tenth of the cost of expansions.
///
/// Source: M. Joldes, J.-M. Muller, V. Popescu, "Tight and rigorous error bounds for basic building
/// blocks of double-word arithmetic" (2017), algorithms 6 and 10. Each operation is off by at most
/// 7 · 2^-106 of its result. Needs what expansion.h needs. Cost: some 20 flops each.
#pragma once

#include "mesh/geometry/expansion.h"

namespace tetfarm {

struct DoubleDouble {
  double high = 0;
  double low = 0;

  friend DoubleDouble operator-(const DoubleDouble& a) { return {-a.high, -a.low}; }
  friend DoubleDouble operator+(const DoubleDouble& a, const DoubleDouble& b) {
    const TwoTerms s = two_sum(a.high, b.high);
    const TwoTerms t = two_sum(a.low, b.low);
    const TwoTerms v = fast_two_sum(s.high, s.low + t.high);
    const TwoTerms z = fast_two_sum(v.high, t.low + v.low);
    return {z.high, z.low};
  }
  friend DoubleDouble operator-(const DoubleDouble& a, const DoubleDouble& b) { return a + -b; }
  friend DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b) {
    const TwoTerms c = two_product(a.high, b.high);
    const double cross = a.high * b.low + a.low * b.high;
    const TwoTerms z = fast_two_sum(c.high, c.low + cross);
    return {z.high, z.low};
  }
  friend bool operator<(const DoubleDouble& a, const DoubleDouble& b) {
    return a.high < b.high || (a.high == b.high && a.low < b.low);
  }
  /// Two steps of long division; good to a few units of 2^-104.
  friend DoubleDouble operator/(const DoubleDouble& a, const DoubleDouble& b) {
    const double first = a.high / b.high;
    const DoubleDouble rest = a - DoubleDouble{first, 0} * b;
    const double second = rest.high / b.high;
    const DoubleDouble last = rest - DoubleDouble{second, 0} * b;
    const TwoTerms z = fast_two_sum(first, second);
    return DoubleDouble{z.high, z.low} + DoubleDouble{last.high / b.high, 0};
  }
};

inline DoubleDouble magnitude(const DoubleDouble& a) { return a.high < 0 ? -a : a; }

/// Without error.
inline DoubleDouble double_difference(double a, double b) {
  const TwoTerms t = two_sum(a, -b);
  return {t.high, t.low};
}

}  // namespace tetfarm
