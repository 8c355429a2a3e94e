/// The command line of `tetfarm doctor`.
#pragma once

#include <CLI/CLI.hpp>

#include "cli/command_line.h"

namespace tetfarm {

/// Adds its options to the sub-command. @pre `doctor` outlives it.
void add_doctor(CLI::App& sub, DoctorCommand& doctor);

}  // namespace tetfarm
