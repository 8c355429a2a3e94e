/// How long a task will take, by what is known of it before it runs, and how sure that is; learnt
/// from tasks that are done.
///
/// Source: none in the thesis. The CPU seconds of a kind of task are a sum: a fixed part, so much
/// for each element and each triangle, and for needles so much as grows with the square of their
/// number while they are few and with their number when they are many. The built-in terms are
/// measured (docs/measurements/2026-11-plan_accuracy.md). What a store has seen changes them: each
/// term gets a factor, by least squares of relative errors, held near 1 until the measurements
/// speak for something else; and what remains of the errors, term by term, says how sure the sum
/// is. Units: CPU seconds.
#pragma once

#include <array>
#include <cstddef>
#include <deque>

#include "tasks/task_kind.h"

namespace tetfarm {

struct TaskSize {
  double elements = 0;
  double triangles = 0;
  double needles = 0;  ///< triangles of the surface with a small angle, mesh/core/triangle_angles.h
};

/// About four of five tasks are meant to lie between low and high.
struct SecondsRange {
  double low = 0;
  double expected = 0;
  double high = 0;

  /// As if all errors of a sum had one cause: a whole job's range is no narrower than its tasks'.
  SecondsRange& operator+=(const SecondsRange& other);
};

/// By the built-in terms alone. Cost: O(1).
SecondsRange usual_seconds(TaskKind kind, const TaskSize& size);

class TaskTimes {
 public:
  /// Of a task that is done. Sizes and seconds that make no sense are left out.
  void learn(TaskKind kind, const TaskSize& size, double cpu_seconds);

  /// By what was learnt of the kind; by the built-in terms where that is nothing.
  SecondsRange seconds(TaskKind kind, const TaskSize& size) const;

  /// Tasks that were learnt from.
  std::size_t learnt() const;

  /// Of a kind; older ones are forgotten.
  static constexpr std::size_t samples_kept = 1000;

  static constexpr std::size_t terms = 4;  ///< fixed, elements, triangles, needles
  using Terms = std::array<double, terms>;

 private:
  struct Sample {
    Terms usual{};  ///< seconds of each built-in term
    double seconds = 0;
  };
  struct Kind {
    std::deque<Sample> samples;
    Terms factors{1, 1, 1, 1};
    Terms spreads{};  ///< of the logarithm of a term
  };
  static constexpr std::size_t kinds = all_task_kinds.size();

  /// Works out the factors and spreads of a kind again. Cost: O(samples).
  static void fit(Kind& kind);

  mutable std::array<Kind, kinds> kinds_;
  mutable std::array<bool, kinds> is_stale_{};
};

}  // namespace tetfarm
