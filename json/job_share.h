/// How much of a whole job is done, 0 to 1, from what the coordinator tells of it: its parts, each
/// with the share of the work that it is on the average.
///
/// Source: CPU seconds by kind of task of docs/measurements (2026-11-subdomains_and_workers.md,
/// 2026-11-thousand_million.md). An estimate: of a job of one leaf meshing is more, of one with a
/// rough surface inspecting is.
#pragma once

#include "proto/messages.pb.h"

namespace tetfarm {

/// 1 of a job that is done only. It may fall from one status to the next, as what is known of a job
/// changes. @param share_of_meshing as MeshingRate has it
double share_of_job(const wire::JobStatus& status, double share_of_meshing);

}  // namespace tetfarm
