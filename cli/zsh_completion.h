/// A script that makes zsh complete the commands, options and values of the program, and say what
/// they are for.
#pragma once

#include <string>

#include "cli/declared_command.h"

namespace tetfarm {

/// To be found as the file _tetfarm in a folder of $fpath, or to be read by `source`.
std::string zsh_completion(const DeclaredCommand& program);

}  // namespace tetfarm
