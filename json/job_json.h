/// Jobs and the farm as JSON. The keys are documented in docs/operations.md and do not change.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "proto/messages.pb.h"

namespace tetfarm {

// One object, one line, no end.

/// {"type":"result", …}: the last line of `run --json`.
std::string result_json(const wire::JobStatus& status, double seconds,
                        const std::vector<std::filesystem::path>& files);

/// {"type":"job", …} of one job of `status --json`.
std::string status_json(const wire::JobStatus& status);

/// {"type":"job", …} of one job of `jobs --json`.
std::string job_json(const wire::JobStatus& job);

/// {"type":"farm", …}: the first line of `status --json` of all jobs.
std::string farm_json(const wire::StatusReply& reply);

/// {"type":what,"file":…}: what commands say that wrote one file.
std::string copy_json(const std::string& what, const std::string& file);

/// {"type":"error","message":…,"exit_code":…}.
std::string error_json(const std::string& message, int exit_code);

/// Hosts in quarantine, and on demand the workers, a line with its end for each.
std::string farm_events_json(const wire::StatusReply& reply, bool with_workers);

// Parts of those.

/// How evenly the work is spread, largest over mean, and what the assimilation came to.
nlohmann::ordered_json balance_json(const wire::JobStatus& status);

/// What each kind of task took, and what it was expected to take (worker/task_cost.h).
nlohmann::ordered_json tasks_json(const wire::JobStatus& status);

}  // namespace tetfarm
