/// What tasks that run do, put into answers. Only in answers: none of it is kept with the rows.
#pragma once

#include <vector>

#include "coordinator/decisions/job_state.h"
#include "proto/messages.pb.h"

namespace tetfarm {

/// The longest running ones of the job's `tasks`, by attempt, and what those that mesh have made of
/// their expected elements, all together. Cost: O(tasks).
void add_running_tasks(const JobState& state, const std::vector<const TaskRow*>& tasks, Moment now,
                       wire::JobStatus& status);

/// Of a task that runs, as far as its worker has said.
void add_doing(const JobState& state, const TaskRow& task, wire::TaskLine& line);
void add_doing(const JobState& state, const WorkerAtWork& at_work, wire::WorkerLine& line);

}  // namespace tetfarm
