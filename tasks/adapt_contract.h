/// The contract of adapt: the mesh of the next cycle of a loop, and the solution brought to it.
#pragma once

#include <cstdint>

#include "tasks/task_contract.h"
#include "tasks/task_kind.h"

namespace tetfarm {

struct AdaptGiven {
  TaskFile job;  ///< of the loop
  TaskFile mesh;
  TaskFile solution;
  LeafFiles splines;  ///< loops of points, by their place in spline_files() of the job, from 1
  std::uint64_t cycle = 2;  ///< whose mesh it makes

  static constexpr TaskKind kind = TaskKind::adapt;
  static constexpr ContractSide side = ContractSide::given;
  void describe(ContractFields& fields);
};

struct AdaptMade {
  TaskFile mesh;
  TaskFile start;    ///< the solution on it
  TaskFile figures;  ///< a row of the table of cycles (worker/cycle_figures.h)

  static constexpr TaskKind kind = TaskKind::adapt;
  static constexpr ContractSide side = ContractSide::made;
  void describe(ContractFields& fields);
};

}  // namespace tetfarm
