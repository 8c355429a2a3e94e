/// The contract of extract: the elements of a leaf that are near its cuts.
#pragma once

#include "tasks/task_contract.h"
#include "tasks/task_kind.h"

namespace tetfarm {

struct ExtractGiven {
  TaskFile subdomain;
  TaskFile mesh;
  TaskFile shared;

  static constexpr TaskKind kind = TaskKind::extract;
  static constexpr ContractSide side = ContractSide::given;
  void describe(ContractFields& fields);
};

struct ExtractMade {
  TaskFile elements;

  static constexpr TaskKind kind = TaskKind::extract;
  static constexpr ContractSide side = ContractSide::made;
  void describe(ContractFields& fields);
};

}  // namespace tetfarm
