/// The contract of assimilate: joins leaves into groups of even work.
#pragma once

#include <string>

#include "tasks/task_contract.h"
#include "tasks/task_kind.h"

namespace tetfarm {

struct AssimilateGiven {
  TaskFile job;
  LeafFiles subdomains;  ///< every leaf
  std::string table;     ///< "HEAP WORK", a line for each leaf

  static constexpr TaskKind kind = TaskKind::assimilate;
  static constexpr ContractSide side = ContractSide::given;
  void describe(ContractFields& fields);
};

struct AssimilateMade {
  LeafFiles group_files;  ///< by the first leaf of the group
  TaskFile dropped;       ///< nodes of cuts that are inside a group now
  std::string groups;     ///< "HEAP GROUP", a line for each leaf

  static constexpr TaskKind kind = TaskKind::assimilate;
  static constexpr ContractSide side = ContractSide::made;
  void describe(ContractFields& fields);
};

}  // namespace tetfarm
