#include "store/task_time.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"
#include "tasks/task_kind.h"

namespace tetfarm {
namespace {

using Terms = TaskTimes::Terms;

/// Of the normal distribution: four of five lie so many deviations from the middle.
constexpr double deviations = 1.28;

/// What a task takes differs by so much from what the best terms say.
constexpr double noise = 0.3;
/// What was believed weighs as much as so many samples.
constexpr double belief_samples = 3;
/// Recovering a needle is slowed down by those near it.
constexpr double few_needles = 2000;
/// Seconds below this are of the clock and the system, not of the task.
constexpr double least_seconds = 0.005;
constexpr double least_factor = 0.05;
constexpr double most_factor = 100;

Terms usual_terms(TaskKind kind, const TaskSize& size) {
  const Terms& of_one = traits_of(kind).seconds.of;
  return {of_one[0], of_one[1] * size.elements, of_one[2] * size.triangles,
          of_one[3] * size.needles * size.needles / (size.needles + few_needles)};
}

double dot(const Terms& a, const Terms& b) {
  double sum = 0;
  for (std::size_t j = 0; j < a.size(); ++j) sum += a[j] * b[j];
  return sum;
}

SecondsRange range_of(const Terms& terms, const Terms& spreads) {
  SecondsRange range;
  for (std::size_t j = 0; j < terms.size(); ++j) {
    range.expected += terms[j];
    range.low += terms[j] * std::exp(-deviations * spreads[j]);
    range.high += terms[j] * std::exp(deviations * spreads[j]);
  }
  return range;
}

/// Symmetric positive definite: each row's diagonal has the belief in its factor.
using Matrix = std::array<Terms, TaskTimes::terms>;

Terms solve(Matrix m, Terms right) {
  constexpr std::size_t n = TaskTimes::terms;
  for (std::size_t k = 0; k < n; ++k) {
    for (std::size_t i = k + 1; i < n; ++i) {
      const double factor = m[i][k] / m[k][k];
      for (std::size_t j = k; j < n; ++j) m[i][j] -= factor * m[k][j];
      right[i] -= factor * right[k];
    }
  }
  for (std::size_t k = n; k-- > 0;) {
    for (std::size_t j = k + 1; j < n; ++j) right[k] -= m[k][j] * right[j];
    right[k] /= m[k][k];
  }
  return right;
}

}  // namespace

SecondsRange& SecondsRange::operator+=(const SecondsRange& other) {
  low += other.low;
  expected += other.expected;
  high += other.high;
  return *this;
}

SecondsRange usual_seconds(TaskKind kind, const TaskSize& size) {
  return range_of(usual_terms(kind, size), traits_of(kind).seconds.spreads);
}

void TaskTimes::learn(TaskKind kind, const TaskSize& size, double cpu_seconds) {
  const auto makes_sense = [](double x) { return std::isfinite(x) && x >= 0; };
  if (!makes_sense(size.elements) || !makes_sense(size.triangles) || !makes_sense(size.needles) ||
      !makes_sense(cpu_seconds)) {
    return;
  }
  const auto k = static_cast<std::size_t>(kind);
  TF_CHECK(k < kinds_.size());
  kinds_[k].samples.push_back({usual_terms(kind, size), std::max(cpu_seconds, least_seconds)});
  if (kinds_[k].samples.size() > samples_kept) kinds_[k].samples.pop_front();
  is_stale_[k] = true;
}

void TaskTimes::fit(Kind& kind) {
  const Terms believed = kind.spreads;
  TF_CHECK(!kind.samples.empty() && kind.samples.size() <= samples_kept);
  Matrix m{};
  Terms right{};
  for (std::size_t j = 0; j < terms; ++j) {
    m[j][j] = 1 / (believed[j] * believed[j]);
    right[j] = m[j][j];
  }
  for (const Sample& sample : kind.samples) {
    const double weight = 1 / (noise * sample.seconds);
    for (std::size_t i = 0; i < terms; ++i) {
      for (std::size_t j = 0; j < terms; ++j) {
        m[i][j] += weight * sample.usual[i] * weight * sample.usual[j];
      }
      right[i] += weight * sample.usual[i] * weight * sample.seconds;
    }
  }
  kind.factors = solve(m, right);
  for (double& factor : kind.factors) factor = std::clamp(factor, least_factor, most_factor);
  Terms weights;
  Terms squares;
  for (std::size_t j = 0; j < terms; ++j) {
    weights[j] = belief_samples;
    squares[j] = belief_samples * believed[j] * believed[j];
  }
  for (const Sample& sample : kind.samples) {
    const double expected = dot(kind.factors, sample.usual);
    const double error = std::log(sample.seconds / expected);
    for (std::size_t j = 0; j < terms; ++j) {
      const double share = kind.factors[j] * sample.usual[j] / expected;
      weights[j] += share;
      squares[j] += share * error * error;
    }
  }
  for (std::size_t j = 0; j < terms; ++j) kind.spreads[j] = std::sqrt(squares[j] / weights[j]);
}

SecondsRange TaskTimes::seconds(TaskKind kind, const TaskSize& size) const {
  const auto k = static_cast<std::size_t>(kind);
  TF_CHECK(k < kinds_.size());
  if (kinds_[k].samples.empty()) return usual_seconds(kind, size);
  if (is_stale_[k]) {
    kinds_[k].spreads = traits_of(kind).seconds.spreads;
    fit(kinds_[k]);
    is_stale_[k] = false;
  }
  Terms now = usual_terms(kind, size);
  for (std::size_t j = 0; j < terms; ++j) now[j] *= kinds_[k].factors[j];
  return range_of(now, kinds_[k].spreads);
}

std::size_t TaskTimes::learnt() const {
  std::size_t count = 0;
  for (const Kind& kind : kinds_) count += kind.samples.size();
  return count;
}

}  // namespace tetfarm
