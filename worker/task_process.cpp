#include "worker/task_process.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <unistd.h>

#include "base/child_process.h"
#include "base/sanitizers.h"

namespace tetfarm {
namespace {

// A sanitizer's shadow of the address space counts as data, and is larger than any machine's
// memory.
constexpr bool can_limit_memory = !is_sanitized;

}  // namespace

void become_task_process(pid_t worker, TaskFds fds, std::uint64_t memory_limit_bytes) {
  live_with_parent(worker);
  // Above the targets first, so that no dup2 closes what a later one needs.
  fds = {::fcntl(fds.in, F_DUPFD, 10), ::fcntl(fds.words, F_DUPFD, 10),
         ::fcntl(fds.frames, F_DUPFD, 10)};
  ::dup2(fds.in, STDIN_FILENO);
  ::dup2(fds.words, STDOUT_FILENO);
  ::dup2(fds.words, STDERR_FILENO);
  ::dup2(fds.frames, task_result_fd);
  ::close_range(task_result_fd + 1, ~0U, 0);
  if (can_limit_memory && memory_limit_bytes > 0) {
    const rlimit limit{memory_limit_bytes, memory_limit_bytes};
    ::setrlimit(RLIMIT_DATA, &limit);
  }
  const rlimit no_core{0, 0};
  ::setrlimit(RLIMIT_CORE, &no_core);
}

}  // namespace tetfarm
