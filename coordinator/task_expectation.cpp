#include "coordinator/task_expectation.h"

#include <algorithm>
#include <cstdlib>
#include <vector>

namespace tetfarm {
namespace {

/// Estimated elements of the task's sub-domain; 1 where the task does not name them.
double work_of(const TaskRow& task) {
  const auto work = task.parameters.find("work");
  if (work == task.parameters.end()) return 1;
  return std::max(1.0, std::strtod(work->second.c_str(), nullptr));
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
  if (samples.seconds.empty()) return std::nullopt;
  return samples.median_seconds * work_of(task);
}

std::uint64_t TaskExpectation::bytes(TaskKind kind) const {
  return static_cast<std::uint64_t>(samples_[static_cast<std::size_t>(kind)].median_bytes);
}

}  // namespace tetfarm
