#include "coordinator/decisions/task_expectation.h"

#include <algorithm>
#include <vector>

#include "coordinator/decisions/task_rows.h"
#include "store/task_time.h"

namespace tetfarm {
namespace {

/// Estimated elements of the task's sub-domain, with so many more as take as long as its needles;
/// 1 where the task is not told them.
double work_of(const TaskRow& task) {
  const std::optional<ToldSize> told = told_size(task);
  if (!told) return 1;
  const double elements = std::max(1.0, told->elements);
  const double needles = told->needles;
  constexpr double many = 1e6;
  const auto usual = [&task](double elements_of, double needles_of) {
    return usual_seconds(task.kind, {elements_of, 0, needles_of}).expected;
  };
  const double of_element = (usual(many, 0) - usual(0, 0)) / many;
  if (!(needles > 0) || !(of_element > 0)) return elements;
  return elements + (usual(0, needles) - usual(0, 0)) / of_element;
}

double median_of(const std::deque<double>& samples) {
  std::vector<double> sorted(samples.begin(), samples.end());
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
  std::nth_element(sorted.begin(), middle, sorted.end());
  return *middle;
}

double add_sample(std::deque<double>& samples, double value) {
  samples.push_back(value);
  if (samples.size() > TaskExpectation::samples_kept) samples.pop_front();
  return median_of(samples);
}

}  // namespace

void TaskExpectation::learn(const TaskRow& done) {
  Samples& samples = samples_[static_cast<std::size_t>(done.kind)];
  samples.median_seconds = add_sample(samples.seconds, done.seconds / work_of(done));
  samples.median_bytes = add_sample(samples.bytes, static_cast<double>(done.peak_rss_bytes));
}

std::optional<double> TaskExpectation::seconds(const TaskRow& task) const {
  const Samples& samples = samples_[static_cast<std::size_t>(task.kind)];
  if (samples.seconds.empty() || traits_of(task.kind).is_of_others) return std::nullopt;
  return samples.median_seconds * work_of(task);
}

std::uint64_t TaskExpectation::bytes(TaskKind kind) const {
  return static_cast<std::uint64_t>(samples_[static_cast<std::size_t>(kind)].median_bytes);
}

}  // namespace tetfarm
