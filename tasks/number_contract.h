/// The contract of number: global numbers, from counts alone.
#pragma once

#include <optional>
#include <string>

#include "tasks/task_contract.h"
#include "tasks/task_kind.h"

namespace tetfarm {

struct NumberGiven {
  TaskFile surface;
  std::optional<TaskFile> layer_table;  ///< of a job with layers: more lines of the table
  std::optional<TaskFile> dropped;      ///< of an assimilated job
  LeafFiles cores;                      ///< after cosmetics, of every leaf
  LeafFiles elements;                   ///< the same
  std::string table;                    ///< a line for each sub-domain: proto/protocol.md
  std::optional<std::string> order;     ///< after cosmetics

  static constexpr TaskKind kind = TaskKind::number;
  static constexpr ContractSide side = ContractSide::given;
  void describe(ContractFields& fields);
};

struct NumberMade {
  TaskFile numbering;

  static constexpr TaskKind kind = TaskKind::number;
  static constexpr ContractSide side = ContractSide::made;
  void describe(ContractFields& fields);
};

}  // namespace tetfarm
