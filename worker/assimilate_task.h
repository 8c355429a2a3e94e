/// The task `assimilate`: joins the leaves of an over-decomposition into groups of about equal work
/// (thesis 4.3.2).
///
/// Inputs: "job", "subdomain:HEAP" of every leaf; parameter "table", a line "HEAP WORK" for each.
/// Outputs: "group:HEAP", a sub-domain, for each group, HEAP its first leaf; "dropped", lines for
/// the numbering (mesh/assemble/global_numbering.h). Text "groups": a line "HEAP GROUP" for each
/// leaf. Numbers, as in thesis figs. 69 to 71: leaves, groups; faces_max, faces_mean,
/// estimated_max, estimated_mean of the groups, leaf_faces_max … of the leaves before;
/// communication_nodes_max and communication_nodes_sum over the groups.
///
/// The one task that needs all leaves at once: who is joined with whom depends on all of them.
#pragma once

#include "worker/task_io.h"

namespace tetfarm {

/// The leaves pass through memory one by one for the graph, then group by group.
/// @throws Error when the leaves do not fit together.
void assimilate_task(TaskIo& io);

}  // namespace tetfarm
