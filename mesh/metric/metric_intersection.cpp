#include "mesh/metric/metric_intersection.h"

#include <cmath>
#include <tuple>

#include "base/check.h"
#include "mesh/geometry/double_double.h"

namespace tetfarm {
namespace {

using Wide = DoubleDouble;

Wide wide(double value) { return {value, 0}; }

Wide square_root(const Wide& value) {
  if (value.high <= 0) return {};
  const double first = std::sqrt(value.high);
  const Wide rest = value - wide(first) * wide(first);
  return wide(first) + wide(rest.high / (2 * first));
}

struct WideMatrix {
  Wide xx, xy, yy;
};

/// What the positive part of N - 1 adds to 1: N's eigenvalues that are below 1 become 1.
/// N = 1 + r (n nᵀ) + s (t tᵀ) with r >= s.
WideMatrix at_least_one(const WideMatrix& n) {
  const Wide half = wide(0.5);
  const Wide mean = (n.xx + n.yy) * half;
  const Wide difference = (n.xx - n.yy) * half;
  const Wide radius = square_root(difference * difference + n.xy * n.xy);
  const Wide one = wide(1);
  const bool first_is_less = !(one < mean + radius);
  const bool second_is_less = mean - radius < one;
  if (!second_is_less) return n;
  if (first_is_less || radius.high <= 0) return {one, {}, one};
  // The projection on the first direction is (1 + D / radius) / 2, with D the part of N that has
  // no trace.
  const Wide gain = (mean + radius - one) * half;
  const Wide turned = gain / radius;
  return {one + gain + turned * difference, turned * n.xy, one + gain - turned * difference};
}

/// Whether a asks for at least as much as b in every direction; false where rounding might decide.
bool surely_covers(const Metric2& a, const Metric2& b) {
  const Metric2 rest{a.xx - b.xx, a.xy - b.xy, a.yy - b.yy};
  return rest.xx > 0 && rest.yy > 0 && rest.xx * rest.yy > rest.xy * rest.xy * (1 + 1e-14);
}

}  // namespace

Metric2 intersection(const Metric2& a, const Metric2& b) {
  if (a == b || surely_covers(a, b)) return a;
  if (surely_covers(b, a)) return b;
  if (std::tie(b.xx, b.xy, b.yy) < std::tie(a.xx, a.xy, a.yy)) return intersection(b, a);
  // A = L Lᵀ with L = [p 0; q r].
  const Wide p = square_root(wide(a.xx));
  const Wide q = wide(a.xy) / p;
  const Wide det = wide(a.xx) * wide(a.yy) - wide(a.xy) * wide(a.xy);
  const Wide r = square_root(det) / p;
  // N = L⁻¹ B L⁻ᵀ.
  const Wide xy_row = wide(b.xy) / p;
  const Wide nxx = wide(b.xx) / p / p;
  const Wide nxy = (xy_row - q * nxx) / r;
  const Wide nyy = ((wide(b.yy) - q * xy_row) / r - q * nxy) / r;
  const WideMatrix n = at_least_one({nxx, nxy, nyy});
  const Wide xx = p * p * n.xx;
  const Wide xy = p * (q * n.xx + r * n.xy);
  const Wide yy = q * (q * n.xx + r * n.xy) + r * (q * n.xy + r * n.yy);
  return {xx.high, xy.high, yy.high};
}

Metric2 intersection(std::span<const Metric2> metrics) {
  TF_CHECK(!metrics.empty());
  Metric2 all = metrics.front();
  for (const Metric2& m : metrics.subspan(1)) all = intersection(all, m);
  return all;
}

}  // namespace tetfarm
