/// Where the contracts of each kind are: inspect_contracts in inspect_contract.cpp, and so on.
/// Others ask task_contracts.h.
#pragma once

#include <string>

#include "tasks/task_contract.h"
#include "tasks/task_kind.h"

namespace tetfarm {

struct KindContracts {
  std::string (*breach_of_given)(const TaskWords& words);
  std::string (*breach_of_made)(const TaskWords& words);
};

template <class Contract>
std::string breach_of(const TaskWords& words) {
  return from_words<Contract>(words).breach;
}

template <class Given, class Made>
inline constexpr KindContracts contracts_between = {&breach_of<Given>, &breach_of<Made>};

#define TETFARM_DECLARED(kind) extern const KindContracts kind##_contracts;
TETFARM_TASK_KINDS(TETFARM_DECLARED)
#undef TETFARM_DECLARED

}  // namespace tetfarm
