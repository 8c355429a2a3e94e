/// What tasks that run do, in lines for people.
#pragma once

#include <string>

#include "proto/messages.pb.h"

namespace tetfarm {

/// A line for each of the few that run longest and of which something is known.
std::string running_tasks_text(const wire::JobStatus& status);

/// "recovery pass 3: 312 of 1,204 edges, about 21 % of the task"; "" when nothing is known.
std::string doing_with_share(const wire::TaskLine& task);

}  // namespace tetfarm
