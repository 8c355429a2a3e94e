/// The contract of whatever kind, for who has a task of any kind at hand.
#pragma once

#include <string>

#include "tasks/task_contract.h"
#include "tasks/task_kind.h"

namespace tetfarm {

/// Whether a task of the kind can be given these words. @throws ContractBreach.
void require_given(TaskKind kind, const TaskWords& words, const std::string& whose);

/// Whether these words are what a task of the kind makes. @throws ContractBreach.
void require_made(TaskKind kind, const TaskWords& words, const std::string& whose);

}  // namespace tetfarm
