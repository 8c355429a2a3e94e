/// Runs one task and turns whatever becomes of it into a message: the one place where a task's
/// exceptions are caught.
#pragma once

#include <filesystem>
#include <functional>

#include "worker/task_io.h"

namespace tetfarm {

/// What a task does.
using TaskBody = std::function<void(TaskIo&)>;

/// Runs the body. Done with its outputs, or Failed:
/// bad input (InvalidInput, RefusedInput) and a wrong job file fail for good; a full disk and a
/// lack of memory have causes of their own; everything else is an error, and worth another try. A
/// task `is_without_shared_store` where no other task sees the store.
wire::Envelope run_task(const ArtifactStore& store, const wire::Assign& assign,
                        const TaskBody& body, const TaskIo::Say& say,
                        bool is_without_shared_store = false);

/// The same in the store of that folder, which must be there.
wire::Envelope run_task_in(const std::filesystem::path& store, const wire::Assign& assign,
                           const TaskBody& body, const TaskIo::Say& say,
                           bool is_without_shared_store = false);

}  // namespace tetfarm
