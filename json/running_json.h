/// What tasks that run do, as JSON.
#pragma once

#include <nlohmann/json.hpp>

#include "proto/messages.pb.h"

namespace tetfarm {

/// The keys "doing", "doing_stage", "doing_pass", "doing_done", "doing_total" and "share" of a
/// TaskLine or RunningTask; "" and 0 where nothing is known.
template <class Task>
void add_doing(const Task& task, nlohmann::ordered_json& json);

/// Of a job's tasks that run, the longest running first.
nlohmann::ordered_json running_json(const wire::JobStatus& status);

}  // namespace tetfarm
