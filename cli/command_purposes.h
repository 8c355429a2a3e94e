/// What commands are for: help, the manual and the list that the program shows when it is called
/// without a command have them in groups.
#pragma once

#include <string>

#include "cli/declared_command.h"

namespace tetfarm {

/// The purpose of the commands that those use who keep a farm running.
inline constexpr const char* of_operators = "Keep a farm running";

/// Puts each command of the program into its group. @pre each but the hidden ones has a purpose.
void group_by_purpose(CLI::App& program);

/// Each purpose with its commands, in the order of their declarations and in lines of at most 80
/// letters.
std::string commands_by_purpose(const DeclaredCommand& program);

}  // namespace tetfarm
