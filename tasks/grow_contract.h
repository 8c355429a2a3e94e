/// The contract of grow: the share of a chunk of layers in the global mesh, and its cells.
#pragma once

#include "tasks/task_contract.h"
#include "tasks/task_kind.h"

namespace tetfarm {

struct GrowGiven {
  TaskFile job;
  TaskFile surface;
  TaskFile numbering;
  TaskFile layers;  ///< the chunk

  static constexpr TaskKind kind = TaskKind::grow;
  static constexpr ContractSide side = ContractSide::given;
  void describe(ContractFields& fields);
};

struct GrowMade {
  TaskFile portion;
  TaskFile cells;

  static constexpr TaskKind kind = TaskKind::grow;
  static constexpr ContractSide side = ContractSide::made;
  void describe(ContractFields& fields);
};

}  // namespace tetfarm
