/// The contract of solve: a program of somebody else's computes a solution on the mesh of a cycle.
#pragma once

#include <cstdint>
#include <optional>

#include "tasks/task_contract.h"
#include "tasks/task_kind.h"

namespace tetfarm {

/// Files that a solver of a loop may bring along.
inline constexpr std::uint64_t most_solver_files = 10'000;

struct SolveGiven {
  TaskFile job;  ///< of the loop
  TaskFile mesh;
  std::optional<TaskFile> start;       ///< the solution of the cycle before, on this mesh
  std::optional<TaskFile> file_names;  ///< a line for each of `files`
  LeafFiles files;                     ///< that lie beside the mesh, from 1
  LeafFiles splines;                   ///< for adapt, which follows
  std::uint64_t cycle = 1;
  std::uint64_t cycles = 1;  ///< of the loop

  static constexpr TaskKind kind = TaskKind::solve;
  static constexpr ContractSide side = ContractSide::given;
  void describe(ContractFields& fields);
};

struct SolveMade {
  TaskFile solution;
  TaskFile log;    ///< what the solver said
  LeafFiles kept;  ///< by their place in the job's list of files to keep, from 1

  static constexpr TaskKind kind = TaskKind::solve;
  static constexpr ContractSide side = ContractSide::made;
  void describe(ContractFields& fields);
};

}  // namespace tetfarm
