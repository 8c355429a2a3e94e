/// Which tasks an adaptation loop is made of: solve → adapt → solve → … → solve → collect.
///
/// The path of a task is the number of its cycle; that of collect is 0. As task_graph.h, a pure
/// function of results. Source: thesis 3.3.
#pragma once

#include <functional>

#include "coordinator/decisions/task_graph.h"
#include "tasks/solve_contract.h"

namespace tetfarm {

/// The task of a kind and cycle.
using FindOfCycle = std::function<const TaskRow*(TaskKind kind, std::uint64_t cycle)>;

/// What comes after a cycle's solution: the mesh of the next cycle, or the end. @pre `solve` is
/// done and without problem, and so is every task before it, which `find` finds.
TaskRow after_solve(const TaskRow& solve, const FindOfCycle& find);

/// The solver on the new mesh. @pre both are done and without problem; `solve` is that of the cycle
/// before.
TaskRow after_adapt(const TaskRow& adapt, const TaskRow& solve);

}  // namespace tetfarm
