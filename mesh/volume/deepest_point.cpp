#include "mesh/volume/deepest_point.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

namespace tetfarm {
namespace {

/// sum of a[j] x[j] <= a[N].
template <std::size_t N>
using Constraint = std::array<double, N + 1>;

template <std::size_t N>
bool holds(const Constraint<N>& a, const std::array<double, N>& x) {
  double sum = 0;
  for (std::size_t j = 0; j < N; ++j) sum += a[j] * x[j];
  return sum <= a[N];
}

/// The unknown k taken out of `a` by means of `tight`, in which it has the largest factor.
template <std::size_t N>
Constraint<N - 1> without(const Constraint<N>& a, const Constraint<N>& tight, std::size_t k) {
  const double share = a[k] / tight[k];
  Constraint<N - 1> less{};
  for (std::size_t j = 0, to = 0; j <= N; ++j) {
    if (j != k) less[to++] = a[j] - share * tight[j];
  }
  return less;
}

/// Maximises goal * x.
std::array<double, 1> solve(const std::vector<Constraint<1>>& constraints, std::size_t count,
                            const std::array<double, 1>& goal) {
  double low = -HUGE_VAL;
  double high = HUGE_VAL;
  for (std::size_t i = 0; i < count; ++i) {
    const auto& [a, b] = constraints[i];
    if (a > 0) high = std::min(high, b / a);
    if (a < 0) low = std::max(low, b / a);
  }
  if (low > high) return {0.5 * (low + high)};
  const double best = goal[0] > 0 ? high : low;
  return {std::isfinite(best) ? best : 0};
}

/// The first 2 N constraints bound the unknowns; `order` of the others is by chance.
template <std::size_t N>
std::array<double, N> solve(const std::vector<Constraint<N>>& constraints, std::size_t count,
                            const std::array<double, N>& goal) {
  std::array<double, N> x{};
  std::size_t known = std::min(count, 2 * N);
  for (std::size_t j = 0; j < N; ++j) {
    x[j] = goal[j] >= 0 ? constraints[2 * j][N] : -constraints[2 * j + 1][N];
  }
  for (std::size_t i = known; i < count; ++i) {
    const Constraint<N>& tight = constraints[i];
    if (holds<N>(tight, x)) continue;
    std::size_t k = 0;
    for (std::size_t j = 1; j < N; ++j) {
      if (std::abs(tight[j]) > std::abs(tight[k])) k = j;
    }
    if (tight[k] == 0) continue;
    // The bounds of the unknowns that stay come first again, then those of k.
    std::vector<Constraint<N - 1>> less;
    less.reserve(i);
    for (std::size_t c = 0; c < known; ++c) {
      if (c / 2 != k) less.push_back(without<N>(constraints[c], tight, k));
    }
    less.push_back(without<N>(constraints[2 * k], tight, k));
    less.push_back(without<N>(constraints[2 * k + 1], tight, k));
    for (std::size_t c = known; c < i; ++c) less.push_back(without<N>(constraints[c], tight, k));
    Constraint<N> goal_row{};
    std::copy(goal.begin(), goal.end(), goal_row.begin());
    const Constraint<N - 1> row = without<N>(goal_row, tight, k);
    std::array<double, N - 1> less_goal{};
    std::copy_n(row.begin(), N - 1, less_goal.begin());
    const auto y = solve(less, less.size(), less_goal);
    double sum = tight[N];
    for (std::size_t j = 0, from = 0; j < N; ++j) {
      if (j == k) continue;
      x[j] = y[from++];
      sum -= tight[j] * x[j];
    }
    x[k] = sum / tight[k];
  }
  return x;
}

}  // namespace

Vec3 deepest_point(std::vector<HalfSpace> planes, double reach) {
  std::uint64_t state = 1;
  for (std::size_t i = planes.size(); i > 1; --i) {
    state = state * 6364136223846793005ULL + 1442695040888963407ULL;
    std::swap(planes[i - 1], planes[(state >> 33) % i]);
  }
  // Unknowns in units of the reach: the point and its depth t, with t - normal * x <= offset.
  std::vector<Constraint<4>> constraints;
  for (std::size_t j = 0; j < 4; ++j) {
    Constraint<4> bound{};
    bound[j] = 1;
    bound[4] = j == 3 ? 4 : 1;
    constraints.push_back(bound);
    bound[j] = -1;
    constraints.push_back(bound);
  }
  for (const auto& [n, offset] : planes) {
    constraints.push_back({-n.x, -n.y, -n.z, 1, offset / reach});
  }
  const auto x = solve<4>(constraints, constraints.size(), {0, 0, 0, 1});
  return reach * Vec3{x[0], x[1], x[2]};
}

}  // namespace tetfarm
