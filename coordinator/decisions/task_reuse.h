/// Which finished task serves for a new one, so that a job that was changed goes on from what is
/// there instead of doing it again (thesis 4.3.1: a restart with another number of sub-domains).
///
/// Tasks are pure functions: equal inputs and parameters give equal bytes, whichever job they
/// belong to. A cut is one step wider: where to cut depends on the *share* of the left side only,
/// so that the cut of 4 parts into 2 + 2 is the cut of 16 into 8 + 8.
#pragma once

#include <string>

#include "base/hash.h"
#include "store/rows.h"

namespace tetfarm {

/// Equal for two tasks one of which may serve for the other: kind, place, inputs, and parameters
/// (of a decompose task: the share). Cost: O(inputs and parameters).
std::string work_name(const TaskRow& task);

/// Which program did a task that is done; "" when that is not known.
std::string program_of(const TaskRow& done);

/// Equal where the work has the same name and is another's of the same program.
Hash128 work_key(const TaskRow& task, const std::string& program);

/// @pre the two have the same work_name; `done` is done.
bool serves(const TaskRow& done, const TaskRow& wanted);

/// The result of `done` as that of `wanted`, which is done by it.
void take_result(const TaskRow& done, TaskRow& wanted);

}  // namespace tetfarm
