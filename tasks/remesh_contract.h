/// The contract of remesh: even triangles in place of those of the given surface.
#pragma once

#include "tasks/task_contract.h"
#include "tasks/task_kind.h"

namespace tetfarm {

struct RemeshGiven {
  TaskFile job;
  TaskFile input_surface;

  static constexpr TaskKind kind = TaskKind::remesh;
  static constexpr ContractSide side = ContractSide::given;
  void describe(ContractFields& fields);
};

struct RemeshMade {
  TaskFile surface;

  static constexpr TaskKind kind = TaskKind::remesh;
  static constexpr ContractSide side = ContractSide::made;
  void describe(ContractFields& fields);
};

}  // namespace tetfarm
