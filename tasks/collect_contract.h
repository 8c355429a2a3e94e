/// The contract of collect: the results of a loop under the names by which they are delivered.
#pragma once

#include <cstdint>

#include "tasks/task_contract.h"
#include "tasks/task_kind.h"

namespace tetfarm {

/// Files of a cycle that solve keeps: the number of `kept` is this times the cycle, and its place.
inline constexpr std::uint64_t kept_of_cycle = 1000;

/// All by the number of the cycle.
struct CollectGiven {
  TaskFile job;  ///< of the loop
  LeafFiles meshes;
  LeafFiles solutions;
  LeafFiles logs;
  LeafFiles figures;  ///< from the second cycle on
  LeafFiles kept;     ///< by kept_of_cycle

  static constexpr TaskKind kind = TaskKind::collect;
  static constexpr ContractSide side = ContractSide::given;
  void describe(ContractFields& fields);
};

/// The files, for people, and what the cycles came to.
struct CollectMade {
  static constexpr TaskKind kind = TaskKind::collect;
  static constexpr ContractSide side = ContractSide::made;
  void describe(ContractFields& fields);
};

}  // namespace tetfarm
