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
/// bad input (InvalidInput, RefusedInput) and a wrong job file may not be retried; a full disk is
/// out_of_resources, a lack of memory out_of_memory; everything else is worth another try.
wire::Envelope run_task(const ArtifactStore& store, const wire::Assign& assign,
                        const TaskBody& body, const TaskIo::Say& say);

/// The same in the store of that folder, which must be there.
wire::Envelope run_task_in(const std::filesystem::path& store, const wire::Assign& assign,
                           const TaskBody& body, const TaskIo::Say& say);

}  // namespace tetfarm
