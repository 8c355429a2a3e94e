/// The surface that a job makes in place of the given one, `[surface] remesh = true`.
///
/// Source: none in the thesis, whose surfaces come remeshed. Shared by the task `remesh` and by the
/// commands that tell what a job would come to. Lengths in the unit of the input.
#pragma once

#include "mesh/inspect/surface_check.h"
#include "mesh/job_file/job_file.h"
#include "mesh/remeshing/remesh.h"
#include "mesh/remeshing/remeshing_spacing.h"

namespace tetfarm {

/// The job's words in the terms of the mesh rooms, every 0 replaced. @pre the job remeshes.
/// @throws UsageError.
RemeshOptions remesh_options_of(const JobFile& job, const SurfaceMesh& surface);

struct JobRemeshed {
  RemeshedSurface made;
  RemeshingSpacing spacing;
  CheckedSurface checked;  ///< what was made; without defects
};

/// @pre the job remeshes; check_surface found no defect in `surface`. @throws UsageError; Error
/// (failed) where what was made has a defect: a fault of ours. Cost: that of remesh.
JobRemeshed remesh_for_job(const JobFile& job, const SurfaceMesh& surface);

/// What the job is meshed from: `given`, or what that is remeshed to. @pre `given` has no defect.
CheckedSurface surface_to_mesh(const JobFile& job, CheckedSurface given);

}  // namespace tetfarm
