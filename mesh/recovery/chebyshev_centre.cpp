#include "mesh/recovery/chebyshev_centre.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

#include "base/check.h"

namespace tetfarm {
namespace {

double magnitude(double x) { return std::abs(x); }
double rounded(double x) { return x; }
double rounded(const DoubleDouble& x) { return x.high; }

/// sum of a[j] x[j] <= a[N].
template <std::size_t N, typename Number>
using Constraint = std::array<Number, N + 1>;

template <std::size_t N, typename Number>
bool holds(const Constraint<N, Number>& a, const std::array<Number, N>& x) {
  Number sum{0};
  for (std::size_t j = 0; j < N; ++j) sum = sum + a[j] * x[j];
  return !(a[N] < sum);
}

/// The unknown k taken out of `a` by means of `tight`, in which it has the largest factor.
template <std::size_t N, typename Number>
Constraint<N - 1, Number> without(const Constraint<N, Number>& a,
                                  const Constraint<N, Number>& tight, std::size_t k) {
  const Number share = a[k] / tight[k];
  Constraint<N - 1, Number> less{};
  for (std::size_t j = 0, to = 0; j <= N; ++j) {
    if (j != k) less[to++] = a[j] - share * tight[j];
  }
  return less;
}

/// Maximises goal * x.
template <typename Number>
std::array<Number, 1> solve(const std::vector<Constraint<1, Number>>& constraints,
                            std::size_t count, const std::array<Number, 1>& goal) {
  Number low{-HUGE_VAL};
  Number high{HUGE_VAL};
  for (std::size_t i = 0; i < count; ++i) {
    const auto& [a, b] = constraints[i];
    if (Number{0} < a) high = std::min(high, b / a);
    if (a < Number{0}) low = std::max(low, b / a);
  }
  if (high < low) return {Number{0.5} * (low + high)};
  const Number best = Number{0} < goal[0] ? high : low;
  return {std::isfinite(rounded(best)) ? best : Number{0}};
}

/// The first 2 N constraints bound the unknowns; the order of the others is by chance.
template <std::size_t N, typename Number>
std::array<Number, N> solve(const std::vector<Constraint<N, Number>>& constraints,
                            std::size_t count, const std::array<Number, N>& goal) {
  std::array<Number, N> x{};
  const std::size_t known = std::min(count, 2 * N);
  for (std::size_t j = 0; j < N; ++j) {
    x[j] = goal[j] < Number{0} ? -constraints[2 * j + 1][N] : constraints[2 * j][N];
  }
  for (std::size_t i = known; i < count; ++i) {
    const Constraint<N, Number>& tight = constraints[i];
    if (holds<N, Number>(tight, x)) continue;
    std::size_t k = 0;
    for (std::size_t j = 1; j < N; ++j) {
      if (magnitude(tight[k]) < magnitude(tight[j])) k = j;
    }
    if (rounded(tight[k]) == 0) continue;
    // The bounds of the unknowns that stay come first again, then those of k.
    std::vector<Constraint<N - 1, Number>> less;
    less.reserve(i);
    for (std::size_t c = 0; c < known; ++c) {
      if (c / 2 != k) less.push_back(without<N, Number>(constraints[c], tight, k));
    }
    less.push_back(without<N, Number>(constraints[2 * k], tight, k));
    less.push_back(without<N, Number>(constraints[2 * k + 1], tight, k));
    for (std::size_t c = known; c < i; ++c) {
      less.push_back(without<N, Number>(constraints[c], tight, k));
    }
    Constraint<N, Number> goal_row{};
    std::copy(goal.begin(), goal.end(), goal_row.begin());
    const auto row = without<N, Number>(goal_row, tight, k);
    std::array<Number, N - 1> less_goal{};
    std::copy_n(row.begin(), N - 1, less_goal.begin());
    const auto y = solve(less, less.size(), less_goal);
    Number sum = tight[N];
    for (std::size_t j = 0, from = 0; j < N; ++j) {
      if (j == k) continue;
      x[j] = y[from++];
      sum = sum - tight[j] * x[j];
    }
    x[k] = sum / tight[k];
  }
  return x;
}

/// In units of the reach: the point and its depth t, with t - normal * x <= offset. `plane_row`
/// makes the row of a plane.
template <typename Number, typename PlaneRow>
std::array<Number, 4> solve_for_depth(const std::vector<HalfSpace>& planes,
                                      const PlaneRow& plane_row) {
  std::vector<Constraint<4, Number>> constraints;
  for (std::size_t j = 0; j < 4; ++j) {
    Constraint<4, Number> bound{};
    bound[j] = Number{1};
    bound[4] = Number{j == 3 ? 4.0 : 1.0};
    constraints.push_back(bound);
    bound[j] = Number{-1};
    constraints.push_back(bound);
  }
  for (const HalfSpace& plane : planes) constraints.push_back(plane_row(plane));
  std::uint64_t state = 1;
  for (std::size_t i = planes.size(); i > 1; --i) {
    state = state * 6364136223846793005ULL + 1442695040888963407ULL;
    std::swap(constraints[7 + i], constraints[8 + (state >> 33) % i]);
  }
  return solve<4, Number>(constraints, constraints.size(),
                          {Number{0}, Number{0}, Number{0}, Number{1}});
}

}  // namespace

Vec3 chebyshev_centre(const std::vector<HalfSpace>& planes, double reach) {
  TF_CHECK(reach > 0);
  const auto x = solve_for_depth<double>(planes, [reach](const HalfSpace& plane) {
    const Vec3 n = plane.normal.rounded();
    return Constraint<4, double>{-n.x, -n.y, -n.z, 1, plane.offset.high / reach};
  });
  return reach * Vec3{x[0], x[1], x[2]};
}

FineVec3 fine_chebyshev_centre(const std::vector<HalfSpace>& planes, double reach) {
  TF_CHECK(reach > 0);
  const DoubleDouble unit{reach, 0};
  const auto x = solve_for_depth<DoubleDouble>(planes, [&unit](const HalfSpace& plane) {
    const auto& n = plane.normal;
    return Constraint<4, DoubleDouble>{-n.x, -n.y, -n.z, DoubleDouble{1, 0}, plane.offset / unit};
  });
  return {unit * x[0], unit * x[1], unit * x[2]};
}

}  // namespace tetfarm
