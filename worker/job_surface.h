/// The surface of a job, in the lengths of the job.
#pragma once

#include <string>
#include <string_view>

#include "mesh/core/surface_mesh.h"
#include "mesh/job_file/job_file.h"

namespace tetfarm {

/// What is in the file, each coordinate multiplied by the job's scale: the same numbers as of
/// `tetfarm convert --scale`. @throws InvalidInput as read_surface_bytes, and when the scale takes
/// a coordinate out of range.
SurfaceMesh read_surface_of_job(const JobFile& job, std::string_view bytes,
                                const std::string& name);

/// " m" where the job is in metres; "" where nobody has said in what it is.
std::string unit_behind(const JobFile& job);

/// "m, of a surface in mm"; "0.001 times those of the surface's file"; "" where there is nothing to
/// say.
std::string lengths_text(const JobFile& job);

}  // namespace tetfarm
