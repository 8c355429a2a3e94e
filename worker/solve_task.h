/// The task `solve`: the solver of an adaptation loop computes a solution on the mesh of a cycle
/// (thesis 3.3). It is run in a folder of its own that goes with the attempt, if the worker was
/// started with --solvers: a job file says what it runs.
///
/// Inputs: "job", "mesh", "start" from the second cycle on, "file_names" and "file:N" of what the
/// solver brings along. Outputs: "solution", "log", "kept:N" of the files to keep that it left.
/// Number: solver_seconds.
#pragma once

#include "worker/task_io.h"

namespace tetfarm {

/// In the environment of a worker's tasks where they may run solvers.
inline constexpr const char* solvers_variable = "TETFARM_SOLVERS";

void solve_task(TaskIo& io);

}  // namespace tetfarm
