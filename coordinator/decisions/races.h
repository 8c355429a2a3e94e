/// Second attempts of tasks that take much longer than expected: the first of the two results
/// counts, and the other attempt is ended.
///
/// The first attempt of a task is named by its row; its rival, if there is one, is named here.
/// Invariants, checked by validate():
///  1. A rival runs, works on the task that it is named for, and says of itself that it is one.
///  2. Every running attempt that says so is named here.
///  3. A rival is not the attempt that its task's row names.
/// Units: times in milliseconds. Cost: O(log races), where it is not said.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "store/rows.h"

namespace tetfarm {

class Races {
 public:
  /// By how much a running attempt is over its time; nothing when none is expected of its task, and
  /// 0 or less when it is in time.
  using OverTime = std::function<std::optional<std::int64_t>(const AttemptRow&)>;

  /// @pre the task is not raced.
  void begin(TaskId task, AttemptId rival);
  bool is_raced(TaskId task) const { return rivals_.contains(task); }

  /// One of the two attempts has ended, and with it the race. The attempt that goes on, when that
  /// is the rival: from now on it is the task's only one.
  /// @pre `ended` was `first`, the one that its task's row names, or the rival. Nothing happens to
  /// a task that was not raced.
  std::optional<AttemptId> leave(TaskId task, AttemptId ended, AttemptId first);

  /// Tasks over their time that nobody races yet, the latest first; none when it was looked a
  /// moment ago: what is late is so by seconds. Cost: O(running attempts).
  std::vector<TaskId> late_tasks(const std::map<AttemptId, AttemptRow>& running,
                                 const OverTime& over_ms, std::int64_t now_ms);

  /// The broken invariants, in words; empty when all is well. Cost: O(running attempts).
  std::vector<std::string> validate(const std::map<AttemptId, AttemptRow>& running,
                                    const std::map<TaskId, TaskRow>& tasks) const;

 private:
  std::map<TaskId, AttemptId> rivals_;
  std::int64_t next_look_ms_ = std::numeric_limits<std::int64_t>::min();
};

}  // namespace tetfarm
