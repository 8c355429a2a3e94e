/// What stands between a task and a worker: for `tetfarm explain`.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace tetfarm {

struct TaskOutlook {
  /// Why it does not run, in words, what decides most first; last why there is such a task at all,
  /// where that was not planned. Empty when there is nothing to say.
  std::vector<std::string> reasons;
  double expected_seconds = 0;   ///< 0: nothing is known of its kind
  std::int64_t limit_ms = 0;     ///< after which its worker ends it
  std::uint64_t room_bytes = 0;  ///< memory that it is given; 0: not known
};

}  // namespace tetfarm
