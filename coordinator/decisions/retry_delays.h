/// When, and where, a task that failed may be tried again.
///
/// It waits a while, longer after each failure; for another while it goes to a worker on which it
/// has not just failed, where there is one. Forgotten when the task is done, replaced or forgiven.
/// Units: times in milliseconds. Cost: O(log tasks).
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "store/rows.h"

namespace tetfarm {

/// After `count` failures: `first_ms`, doubled by each but the first, at most `longest_ms`.
std::int64_t delay_after(std::uint32_t count, std::int64_t first_ms, std::int64_t longest_ms);

class RetryDelays {
 public:
  /// @param elsewhere_ms how long it waits for a worker on which it has not failed
  explicit RetryDelays(std::int64_t elsewhere_ms) : elsewhere_ms_(elsewhere_ms) {}

  /// It failed, or was lost, on that worker; it may be tried again at once, elsewhere.
  void failed_on(TaskId task, WorkerId worker, std::int64_t now_ms);
  /// It is not tried before.
  void wait_until(TaskId task, std::int64_t until_ms);
  void forget(TaskId task);

  /// How long it still waits; 0 when it may be tried. Where it may be tried: see also
  /// prefers_other.
  std::int64_t wait_ms(TaskId task, std::int64_t now_ms) const;
  /// Whether it goes to any worker but this one, where there is another.
  bool prefers_other(TaskId task, WorkerId worker, std::int64_t now_ms) const;

  /// A task that is not among these, in words; empty when all is well.
  std::vector<std::string> validate(const std::map<TaskId, TaskRow>& tasks) const;

 private:
  struct Delay {
    std::int64_t until_ms = 0;
    WorkerId failed_on;  ///< 0: none
  };

  std::int64_t elsewhere_ms_;
  std::map<TaskId, Delay> delays_;
};

}  // namespace tetfarm
