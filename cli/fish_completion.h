/// A script that makes fish complete the commands, options and values of the program, and say what
/// they are for.
#pragma once

#include <string>

#include "cli/declared_command.h"

namespace tetfarm {

/// For fish 3.0 and later.
std::string fish_completion(const DeclaredCommand& program);

}  // namespace tetfarm
