/// The contract of whatever kind, for who has a task of any kind at hand.
#pragma once

#include <string>

#include "tasks/task_contract.h"
#include "tasks/task_kind.h"

namespace tetfarm {

/// Why a task of the kind cannot be given these words; "" when it can.
std::string breach_of_given(TaskKind kind, const TaskWords& words);

/// Why these words are not what a task of the kind makes; "" when they are.
std::string breach_of_made(TaskKind kind, const TaskWords& words);

}  // namespace tetfarm
