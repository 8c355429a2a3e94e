/// The task `remesh`: even triangles in place of those of the given surface, which is checked
/// first.
///
/// Source: as mesh/remeshing/remesh.h. Inputs: "job" (canonical TOML), "input_surface" (the file as
/// it was, packed or not). Outputs: "surface". Numbers: remesh_triangles_before, remesh_triangles,
/// remesh_smallest_angle_deg, remesh_distance_from_input, remesh_distance_to_input,
/// expected_bytes and expected_seconds (task_cost.h).
#pragma once

#include "worker/task_io.h"

namespace tetfarm {

/// @throws RefusedInput with every defect and a .vtp file of them; UsageError.
void remesh_task(TaskIo& io);

}  // namespace tetfarm
