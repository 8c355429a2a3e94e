/// The contract of write: the share of a leaf in the global mesh.
#pragma once

#include <optional>
#include <string>

#include "tasks/task_contract.h"
#include "tasks/task_kind.h"

namespace tetfarm {

struct WriteGiven {
  TaskFile job;
  TaskFile surface;
  TaskFile numbering;
  TaskFile subdomain;
  TaskFile mesh;
  LeafFiles cores;                      ///< after cosmetics, of the leaf
  LeafFiles elements;                   ///< after cosmetics, of it and its neighbours
  std::optional<std::string> colours;   ///< after cosmetics
  std::optional<TaskFile> top_heights;  ///< of a job with layers

  static constexpr TaskKind kind = TaskKind::write;
  static constexpr ContractSide side = ContractSide::given;
  void describe(ContractFields& fields);
};

struct WriteMade {
  TaskFile portion;
  TaskFile tets;

  static constexpr TaskKind kind = TaskKind::write;
  static constexpr ContractSide side = ContractSide::made;
  void describe(ContractFields& fields);
};

}  // namespace tetfarm
