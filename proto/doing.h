/// What a running task does, on the wire and as counts.
#pragma once

#include <optional>
#include <string>

#include "base/work_stage.h"
#include "proto/messages.pb.h"

namespace tetfarm {

wire::Doing doing_message(const WorkCount& count);

/// What a peer says, made harmless: nothing for a stage that is not known, counts of at most 10^15,
/// and none of them beyond its total.
std::optional<WorkCount> work_count_of(const wire::Doing& doing);

/// What work_text says of it; of a stage that is not known its name. "" when there is none.
std::string doing_text(const wire::Doing& doing);

}  // namespace tetfarm
