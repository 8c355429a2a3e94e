/// A script that makes bash complete the commands, options and values of the program.
#pragma once

#include <string>

#include "cli/declared_command.h"

namespace tetfarm {

/// Needs nothing but bash 4.4, neither the program nor the package bash-completion.
std::string bash_completion(const DeclaredCommand& program);

}  // namespace tetfarm
