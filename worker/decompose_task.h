/// The task `decompose`: one sub-domain becomes two, by a plane.
///
/// Source: thesis 4.3.1, fig. 48. Inputs: "subdomain", "spacing"; parameter "parts", how many
/// leaves are to come of it. Outputs: "left", "right", or none when no plane was found: the
/// sub-domain then stays a leaf, and text "reason" says why. Numbers: left_parts, right_parts,
/// interdomain_nodes, candidates_tried.
#pragma once

#include "mesh/decompose/planar_cut.h"
#include "worker/task_io.h"

namespace tetfarm {

void decompose_task(TaskIo& io);

/// How easily the halves of a cut will be meshed later: found out by recovering their boundaries on
/// trial. `with_points`: recovery has to add points inside.
enum class Recovery { clean, with_points, fails };
Recovery recovery_of(const Subdomain& left, const Subdomain& right, const SpacingField& spacing);

}  // namespace tetfarm
