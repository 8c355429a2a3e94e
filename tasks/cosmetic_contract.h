/// The contract of cosmetic: the turn of a leaf: improves the elements near its cuts.
#pragma once

#include <string>

#include "tasks/task_contract.h"
#include "tasks/task_kind.h"

namespace tetfarm {

struct CosmeticGiven {
  TaskFile spacing;
  TaskFile own;         ///< elements of the leaf
  LeafFiles waiting;    ///< neighbours that have their turn later
  LeafFiles had_turn;   ///< neighbours that had it
  std::string colours;  ///< "HEAP COLOUR", of the leaf and its neighbours

  static constexpr TaskKind kind = TaskKind::cosmetic;
  static constexpr ContractSide side = ContractSide::given;
  void describe(ContractFields& fields);
};

struct CosmeticMade {
  TaskFile elements;

  static constexpr TaskKind kind = TaskKind::cosmetic;
  static constexpr ContractSide side = ContractSide::made;
  void describe(ContractFields& fields);
};

}  // namespace tetfarm
