/// What the command line of a pool says, in the words of its decisions and of its batch system.
#pragma once

#include "cli/command_line.h"
#include "pool/batch_system.h"
#include "pool/decisions.h"

namespace tetfarm {

/// Without a name it is made from the coordinator's address. Sizes are rounded down to mebibytes.
/// @throws UsageError when there would be more workers than there may be, or too small ones.
PoolRules pool_rules(const PoolCommand& command);

/// Paths on this machine become whole. Without a program, this one. @throws filesystem_error.
PoolSettings pool_settings(const PoolCommand& command, const PoolRules& rules);

}  // namespace tetfarm
