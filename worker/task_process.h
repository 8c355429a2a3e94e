/// How a process becomes that of a task: it dies with the worker, has the task's pipes in place and
/// the task's limits.
#pragma once

#include <sys/types.h>

#include <cstdint>

namespace tetfarm {

/// The file descriptor that the task writes its frames to.
inline constexpr int task_result_fd = 3;

/// The task's ends of its pipes; -1: none.
struct TaskFds {
  int in = -1;      ///< the assignment: becomes standard input
  int words = -1;   ///< becomes standard output and error
  int frames = -1;  ///< becomes task_result_fd
};

/// Makes the caller the process of a task of `worker`, its parent: as live_with_parent(), with no
/// other descriptors than the task's, no core dumps, and the limit of what it may write to (0:
/// none). Async-signal-safe.
void become_task_process(pid_t worker, TaskFds fds, std::uint64_t memory_limit_bytes);

}  // namespace tetfarm
