#include "tasks/task_contracts.h"

#include <array>

#include "tasks/kind_contracts.h"

namespace tetfarm {
namespace {

#define TETFARM_CONTRACTS(kind) &kind##_contracts,
constexpr std::array all_contracts = {TETFARM_TASK_KINDS(TETFARM_CONTRACTS)};
#undef TETFARM_CONTRACTS

const KindContracts& contracts_of(TaskKind kind) {
  return *all_contracts.at(static_cast<std::size_t>(kind));
}

}  // namespace

std::string breach_of_given(TaskKind kind, const TaskWords& words) {
  return contracts_of(kind).breach_of_given(words);
}

std::string breach_of_made(TaskKind kind, const TaskWords& words) {
  return contracts_of(kind).breach_of_made(words);
}

}  // namespace tetfarm
