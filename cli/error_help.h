/// What to do about an error: the line that follows it on the terminal.
#pragma once

#include <string>
#include <string_view>

#include "base/error.h"

namespace tetfarm {

/// The error's own remedy where it has one, else what fits its kind and the command that it came
/// from ("run"; "": none was named). "": nothing useful can be said.
std::string help_for(const Error& error, std::string_view command);

/// "error: …" and, where there is one, "help: …", each with a line end.
std::string complaint(const std::string& message, const std::string& help);

}  // namespace tetfarm
