/// The contract of assemble: puts the portions in a row.
#pragma once

#include <optional>

#include "tasks/task_contract.h"
#include "tasks/task_kind.h"

namespace tetfarm {

struct AssembleGiven {
  TaskFile job;
  TaskFile surface;
  TaskFile numbering;
  LeafFiles portions;                 ///< of every leaf, and of every chunk of layers
  LeafFiles tets;                     ///< the same
  std::optional<TaskFile> layer_map;  ///< of a job with layers, to be among its results

  static constexpr TaskKind kind = TaskKind::assemble;
  static constexpr ContractSide side = ContractSide::given;
  void describe(ContractFields& fields);
};

/// The files that the job asks for, and figures of the mesh: both for people.
struct AssembleMade {
  static constexpr TaskKind kind = TaskKind::assemble;
  static constexpr ContractSide side = ContractSide::made;
  void describe(ContractFields& fields);
};

}  // namespace tetfarm
