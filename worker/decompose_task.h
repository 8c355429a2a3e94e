/// The task `decompose`: one sub-domain becomes two, by a plane.
///
/// Source: thesis 4.3.1, fig. 48. Inputs: "job", "subdomain", "spacing"; parameter "parts", how
/// many leaves are to come of it. Outputs: "left", "right", or none when no plane was found: the
/// sub-domain then stays a leaf, and text "reason" says why. Numbers: left_parts, right_parts,
/// interdomain_nodes, candidates_tried.
#pragma once

#include "mesh/decompose/planar_cut.h"
#include "mesh/io/job_file.h"
#include "worker/task_io.h"

namespace tetfarm {

void decompose_task(TaskIo& io);

/// The job's word for planes in the terms of mesh/decompose.
CutPlanes cut_planes_of(const JobFile& job);

/// Whether the boundary of a part of a cut will be recovered when it is meshed: found out on trial.
/// Cost: about a fifth of meshing the part.
bool boundary_recovers(const Subdomain& part, const SpacingField& spacing);

}  // namespace tetfarm
