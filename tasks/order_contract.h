/// The contract of order: who shares nodes with whom, and when each leaf has its turn.
#pragma once

#include <string>

#include "tasks/task_contract.h"
#include "tasks/task_kind.h"

namespace tetfarm {

struct OrderGiven {
  LeafFiles subdomains;  ///< every leaf

  static constexpr TaskKind kind = TaskKind::order;
  static constexpr ContractSide side = ContractSide::given;
  void describe(ContractFields& fields);
};

struct OrderMade {
  LeafFiles shared;   ///< for every leaf
  std::string order;  ///< "HEAP COLOUR NEIGHBOUR…", a line for each leaf

  static constexpr TaskKind kind = TaskKind::order;
  static constexpr ContractSide side = ContractSide::made;
  void describe(ContractFields& fields);
};

}  // namespace tetfarm
