/// What tasks that run do, in JSON for programs and in lines for people.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "proto/messages.pb.h"

namespace tetfarm {

/// The keys "doing", "doing_stage", "doing_pass", "doing_done", "doing_total" and "share" of a
/// TaskLine or RunningTask; "" and 0 where nothing is known.
template <class Task>
void add_doing(const Task& task, nlohmann::ordered_json& json);

/// Of a job's tasks that run, the longest running first.
nlohmann::ordered_json running_json(const wire::JobStatus& status);

/// A line for each of the few that run longest and of which something is known.
std::string running_tasks_text(const wire::JobStatus& status);

/// "recovery pass 3: 312 of 1,204 edges, about 21 % of the task"; "" when nothing is known.
std::string doing_with_share(const wire::TaskLine& task);

}  // namespace tetfarm
