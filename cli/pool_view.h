/// What a pool's decisions see of a farm: the coordinator's status, in their words.
#pragma once

#include "pool/decisions.h"
#include "proto/messages.pb.h"

namespace tetfarm {

/// Workers on hosts in quarantine count as shunned; demands for the same memory are one.
/// Cost: O(workers log hosts + demands log demands).
CoordinatorView coordinator_view(const wire::StatusReply& reply);

}  // namespace tetfarm
