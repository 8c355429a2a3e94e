/// Where the contracts of each kind are: inspect_contracts in inspect_contract.cpp, and so on.
/// Others ask task_contracts.h.
#pragma once

#include <string>

#include "tasks/task_contract.h"
#include "tasks/task_kind.h"

namespace tetfarm {

struct KindContracts {
  void (*require_given)(const TaskWords& words, const std::string& whose);
  void (*require_made)(const TaskWords& words, const std::string& whose);
};

template <class Contract>
void require(const TaskWords& words, const std::string& whose) {
  from_words<Contract>(words, whose);
}

template <class Given, class Made>
inline constexpr KindContracts contracts_between = {&require<Given>, &require<Made>};

#define TETFARM_DECLARED(kind) extern const KindContracts kind##_contracts;
TETFARM_TASK_KINDS(TETFARM_DECLARED)
#undef TETFARM_DECLARED

}  // namespace tetfarm
