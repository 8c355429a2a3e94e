/// What a pool's decisions see of a farm: the coordinator's status, in their words.
#pragma once

#include "pool/decisions.h"
#include "proto/messages.pb.h"

namespace tetfarm {

/// Workers on hosts in quarantine count as shunned; demands for the same memory are one.
/// Cost: O(workers log hosts + demands log demands).
/// @param runs_solvers whether the pool's workers do; without, those that want one are not seen
CoordinatorView coordinator_view(const wire::StatusReply& reply, bool runs_solvers);

}  // namespace tetfarm
