/// The task that grows a chunk of layers, and brings it into the form in which it is assembled.
///
/// Inputs: job, surface, numbering, and "layers", the chunk (mesh/layers/layer_chunk_file.h).
/// Outputs: "portion" and "cells", as those of a write task. Numbers: tets, pyramids, prisms,
/// and quads where there are some.
#pragma once

#include "worker/task_io.h"

namespace tetfarm {

/// @throws OwnDefect where a cell is flat or turned, which the plan of the layers rules out.
void grow_task(TaskIo& io);

}  // namespace tetfarm
