/// The surface that a job is given, read and checked: what its first task begins with.
#pragma once

#include <string>

#include "mesh/inspect/surface_check.h"
#include "mesh/job_file/job_file.h"
#include "worker/task_io.h"

namespace tetfarm {

/// The job's words in the terms of the mesh rooms.
RegionRules region_rules_of(const JobFile& job);

/// The surface of the job's domain as check_surface gives it: of half a body the one that is closed
/// on the plane of symmetry, with the outer boundary, which domain_of_job does not add then.
/// @throws InvalidInput as close_half_body.
CheckedSurface check_surface_of_job(const JobFile& job, SurfaceMesh surface);

struct CheckedInput {
  CheckedSurface checked;
  double bytes = 0;  ///< of the file, unpacked
};

/// Neither the file nor the surface as it was read stays in memory.
/// @param file as it was given, packed or not.
/// @throws RefusedInput with every defect and a .vtp file of them; InvalidInput that names the
/// job's surface.
CheckedInput checked_input(TaskIo& io, const JobFile& job, const TaskFile& file);

}  // namespace tetfarm
