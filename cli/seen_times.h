/// How long tasks took in a store: what `plan` learns from, and how it tells of seconds.
#pragma once

#include <string>

#include "store/task_time.h"

namespace tetfarm {

/// Of every task of a store, or of the folder of a run, that is done; whether a coordinator runs
/// there or not. `store` "": nothing is learnt. `database` "": it lies in the store.
/// @throws Error (not_found) when there is neither; IoError, CorruptFile. Cost: reads all tasks.
TaskTimes times_seen_in(const std::string& store, const std::string& database);

/// "20 to 90 s", "1.2 to 4 min", "0.3 s" where both ends are the same: two digits of each, in the
/// unit that suits the higher.
std::string range_text(double low_seconds, double high_seconds);

}  // namespace tetfarm
