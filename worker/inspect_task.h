/// The task `inspect`: is the input a surface that can be meshed, and how fine is its mesh to be?
///
/// Source: thesis 4.3.1.9 (the background mesh is made once, before any cut).
/// Inputs: "job" (canonical TOML), "input_surface" (the file as it was, packed or not) or, made by
/// the task `remesh`, "remeshed_surface".
/// Outputs: "surface", "spacing", "root"; "settings", the job file as far as the tasks on
/// sub-domains read it. Numbers: parts, groups (0: no assimilation), most_bytes (0: no limit),
/// total_work (elements), needles (triangles with a small angle), expected_bytes and
/// expected_seconds (task_cost.h), forecast_bytes, forecast_disk_bytes and forecast_seconds of the
/// whole job (job_forecast.h), and the report's.
/// Parameter: free_bytes, the room on the store's disk; a job that it cannot hold is refused.
#pragma once

#include "mesh/job_file/job_file.h"
#include "worker/job_domain.h"
#include "worker/task_cost.h"
#include "worker/task_io.h"

namespace tetfarm {

/// @throws RefusedInput with every defect and a .vtp file of them.
void inspect_task(TaskIo& io);

/// The job without what a sub-domain's mesh does not depend on: its name, its regions' names, its
/// numbers of sub-domains, its gate and its formats. Jobs that differ in these only have equal
/// settings, so that their meshes serve each other.
JobFile mesh_settings_of(const JobFile& job);

/// How many leaves the job wants: as it says, or so many that each holds at most target_elements
/// and that there are enough to assimilate; and at least one for each region. Without
/// target_elements a job below 400,000 elements stays whole, and larger ones have four sub-domains,
/// or as many as have 2 million each: by the job alone, never by the machine.
std::int64_t wanted_parts(const JobFile& job, double elements, std::int32_t regions);

/// The same, or as many as max_memory asks for.
std::int64_t parts_of_job(const JobFile& job, const SubdomainSize& root, std::int32_t regions);

/// @throws UsageError when the job's max_memory is less than what the tasks need that do not become
/// smaller by cutting.
void require_room(const JobFile& job, double input_bytes, const SubdomainSize& root);

}  // namespace tetfarm
