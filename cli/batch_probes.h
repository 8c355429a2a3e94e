/// What `tetfarm doctor` asks of batch systems: whether their programs are there, and whether they
/// answer.
#pragma once

#include <cstdint>
#include <string>

#include "cli/findings.h"

namespace tetfarm {

/// @param path of $PATH
/// @param wanted slurm, condor, lsf or ge, which has to be there; "": those that are, and none need
/// be. @throws IoError when there is no room for a process.
Findings look_at_batch_systems(const std::string& path, const std::string& wanted,
                               std::int64_t timeout_ms);

}  // namespace tetfarm
