/// The spacing of a job as the input of a task, left where it lies: a task on a part of a large
/// domain needs little of it.
#pragma once

#include "mesh/spacing/spacing_field.h"
#include "worker/task_io.h"

namespace tetfarm {

/// @throws DamagedInput.
SpacingField spacing_input(const TaskIo& io, const TaskFile& file);

}  // namespace tetfarm
