/// What is the same in every process that is forked to work for this one.
#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

namespace tetfarm {

/// Of the child, after fork: SIGKILL when the thread that started it ends, a process group of its
/// own, no blocked signals. Ends the process if `parent` is gone already. Async-signal-safe.
void live_with_parent(pid_t parent);

/// The words as execve() takes arguments and environment. @pre the words outlive them.
std::vector<char*> exec_arguments(const std::vector<std::string>& words);

}  // namespace tetfarm
