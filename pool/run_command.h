/// Runs a command of a batch system and keeps what it says.
#pragma once

#include <cstdint>

#include "pool/batch_system.h"

namespace tetfarm {

/// Killed, with its children, when it takes longer than timeout_ms. A program that cannot be
/// started ends with 127 and says why. What it leaves running in the background is not waited for.
/// @throws IoError when this process has no room for another.
CommandOutcome run_command(const ShellCommand& command, std::int64_t timeout_ms);

}  // namespace tetfarm
