/// A job's history in the format that Perfetto and chrome://tracing read: a process for each host,
/// a thread for each worker process, a slice for each attempt; and what waited, above all.
///
/// Source: Trace Event Format (Chromium). Units of the file: microseconds since the first event.
#pragma once

#include <string>
#include <vector>

#include "proto/messages.pb.h"

namespace tetfarm {

/// `attempts` by rising id; `events` by rising id, of which those that say a task is ready count.
/// What still runs ends at `now_wall_ms`.
std::string chrome_trace(const std::vector<wire::AttemptLine>& attempts,
                         const std::vector<wire::EventLine>& events, std::int64_t now_wall_ms);

}  // namespace tetfarm
