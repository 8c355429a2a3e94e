/// The task `decompose`: one sub-domain becomes two, by a plane.
///
/// Source: thesis 4.3.1, fig. 48. Inputs: "job", "subdomain", "spacing"; parameters "left_parts"
/// and "right_parts", how many leaves are to come of the halves: their ratio is the share of the
/// work that is wanted on the left. Several regions are divided by region: left_parts and
/// right_parts are then told as numbers. With "most_bytes" the parts come from the real halves: as
/// many as the memory asks for, told as numbers left_parts and right_parts. Parameter "work": its
/// estimated elements.
/// Outputs: "left", "right", or none when no plane was found: the sub-domain then stays a leaf, and
/// text "reason" says why. Numbers: interdomain_nodes, candidates_tried, left_work and right_work
/// (elements), left_needles and right_needles.
#pragma once

#include "mesh/decompose/planar_cut.h"
#include "mesh/job_file/job_file.h"
#include "worker/task_io.h"

namespace tetfarm {

void decompose_task(TaskIo& io);

/// The job's word for planes in the terms of mesh/decompose.
CutPlanes cut_planes_of(const JobFile& job);

}  // namespace tetfarm
