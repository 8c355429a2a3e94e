/// The environment of the processes that do tasks.
#pragma once

#include <string>
#include <vector>

namespace tetfarm {

/// The one given, in the words of execve(), with large pages asked for: a task fills fresh memory
/// all the time, and a fault for each 4 KiB of it takes 6 % of its CPU time
/// (docs/decisions/0002-worker-task-processes.md).
/// Of use where the kernel's transparent_hugepage is "madvise"; a choice that GLIBC_TUNABLES makes
/// already is kept.
std::vector<std::string> task_environment(char* const* environment);

}  // namespace tetfarm
