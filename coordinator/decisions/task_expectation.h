/// What tasks are expected to take, learnt from the finished ones: the median of the last tasks of
/// a kind, seconds in proportion to its elements and needles (task_time.h) where a task names them.
///
/// The expectation decides who gets a task and when one is late; it never decides what a task
/// makes. Of a kind of which none is finished nothing is expected.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <optional>

#include "store/rows.h"
#include "tasks/task_kind.h"

namespace tetfarm {

class TaskExpectation {
 public:
  /// @pre `done` was done by a worker. Cost: O(samples kept).
  void learn(const TaskRow& done);

  /// Of one core. Nothing when none of its kind is finished. Cost: O(1).
  std::optional<double> seconds(const TaskRow& task) const;
  /// Peak memory; 0 when none of its kind is finished.
  std::uint64_t bytes(TaskKind kind) const;

  /// Of a kind; older ones are forgotten.
  static constexpr std::size_t samples_kept = 101;

 private:
  struct Samples {
    std::deque<double> seconds;  ///< for each unit of work, or for the whole task
    std::deque<double> bytes;
    double median_seconds = 0;
    double median_bytes = 0;
  };
  std::array<Samples, all_task_kinds.size()> samples_;
};

}  // namespace tetfarm
