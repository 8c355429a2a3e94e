/// Where the traits of each kind are: inspect_traits in inspect_contract.cpp, and so on. Others ask
/// traits_of (task_kind.h).
#pragma once

#include "tasks/task_kind.h"

namespace tetfarm {

#define TETFARM_DECLARED(kind) extern const TaskKindTraits kind##_traits;
TETFARM_TASK_KINDS(TETFARM_DECLARED)
#undef TETFARM_DECLARED

}  // namespace tetfarm
