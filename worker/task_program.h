/// The program of the child process (ChildTask): which body belongs to which kind of task, and the
/// pipes.
#pragma once

#include <filesystem>

namespace tetfarm {

/// Reads an assignment from `in`, runs it against the store, and writes frames to `out`.
/// @throws Error when the assignment cannot be read, IoError when the worker is gone.
void run_task_program(const std::filesystem::path& store, int in, int out);

}  // namespace tetfarm
