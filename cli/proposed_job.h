/// What a job of a surface is like that says nothing more: for the job file that `init` writes.
///
/// All numbers are those that the job takes by itself, as `plan` and `run` find them. Lengths in
/// the unit of the job.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "cli/job_input.h"
#include "mesh/core/vec3.h"
#include "mesh/inspect/surface_report.h"
#include "mesh/remeshing/remesh_options.h"

namespace tetfarm {

struct ProposedPatch {
  std::string name;
  std::int64_t triangles = 0;
  double median_edge = 0;  ///< 0: it has no triangles
};

struct ProposedJob {
  std::string name;     ///< of the job
  std::string surface;  ///< as the job file is to name it
  std::int64_t triangles = 0;
  Box3 box;
  SurfaceReport report;                ///< without defects
  std::vector<ProposedPatch> patches;  ///< one called "surface" where there are none
  double elements = 0;                 ///< of the space within the surface, estimated
  std::int64_t subdomains = 0;
  double elements_in_box = 0;  ///< the same of the space round it, in a box by default
  double edge_of_box = 0;      ///< the longest on that box
  RemeshOptions remeshing;     ///< where the job says no more than that it remeshes
  double scale = 1;            ///< this and the next: as of JobFile
  std::string unit;
};

/// @param input of a surface, without options but for its unit. @throws Error (bad_geometry) when
/// it cannot be meshed, UsageError as domain_of_job does, InvalidInput. Cost: that of two checks of
/// the surface and of two fields of spacing.
ProposedJob propose_job(const JobInput& input);

}  // namespace tetfarm
