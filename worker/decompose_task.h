/// The task `decompose`: one sub-domain becomes two, by a plane.
///
/// Source: thesis 4.3.1, fig. 48. Inputs: "subdomain", "spacing"; parameter "parts", how many
/// leaves are to come of it. Outputs: "left", "right", or none when no plane was found: the
/// sub-domain then stays a leaf, and text "reason" says why. Numbers: left_parts, right_parts,
/// interdomain_nodes, interdomain_triangles.
#pragma once

#include "mesh/decompose/planar_cut.h"
#include "worker/task_io.h"

namespace tetfarm {

void decompose_task(TaskIo& io);

/// Can both halves of a cut be meshed later without trouble? Recovers their boundaries on trial.
/// `may_add_points`: points that recovery had to add inside are tolerated.
bool halves_recover(const Subdomain& left, const Subdomain& right, const SpacingField& spacing,
                    bool may_add_points);

}  // namespace tetfarm
