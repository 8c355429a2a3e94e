/// A process that has loaded the task's program and starts each task as a copy of itself. Loading
/// takes more than the work of a small task: 35 million instructions, most of them the dynamic
/// loader's.
///
/// The copies are children of the worker, not of the host (CLONE_PARENT): the worker waits for
/// them, learns their peak memory and kills them as it does with a program that it started itself.
/// A copy begins when the worker has heard of it, so none runs that the worker does not know.
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "worker/task_process.h"

namespace tetfarm {

/// The file descriptor at which a host hears its worker.
inline constexpr int task_host_fd = 3;

/// The worker's side. The host starts when it is prepared, or with the first task, and anew when it
/// was killed or stopped.
class TaskHost {
 public:
  /// `command`: a program that calls serve_as_task_host(). Empty: there is no host.
  explicit TaskHost(std::vector<std::string> command) : command_(std::move(command)) {}
  /// Ends the host; its tasks run on.
  ~TaskHost();
  TaskHost(const TaskHost&) = delete;
  TaskHost& operator=(const TaskHost&) = delete;

  /// Has the host load while there is no task yet; where that fails, start() tries again.
  void prepare();

  /// The process of a new task, a child of the caller, with `fds` and limits in place. Nothing when
  /// no host can be had, or it does not answer within `patience_ms`: then the caller starts a
  /// program itself. Call from the thread that outlives the task.
  std::optional<pid_t> start(const std::string& store, TaskFds fds,
                             std::uint64_t memory_limit_bytes, int patience_ms = 3'000);

  pid_t process() const { return process_; }

 private:
  std::optional<pid_t> ask(const std::string& store, TaskFds fds, std::uint64_t memory_limit_bytes,
                           int patience_ms);
  bool launch();
  void end();

  std::vector<std::string> command_;
  pid_t process_ = -1;
  int socket_ = -1;
  int failures_ = 0;  ///< one after the other; after a few it is not tried any more
};

/// The host's side: serves the worker at `socket`, its parent. Returns in every copy, which then is
/// the process of a task, with the store that the task works in; and with nothing in the host
/// itself, when the worker is gone.
std::optional<std::string> serve_as_task_host(int socket);

}  // namespace tetfarm
