/// Words of a command line that mean nothing here, and what was probably meant.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace tetfarm {

/// Word `first` must name a command of `app`, or be an option such as --help; where that command
/// has commands below it, the next word must name one of those.
/// @throws UsageError "unknown command `runn`; did you mean `run`?"
void require_known_command(CLI::App& app, int argc, const char* const* argv, int first = 1);

/// "unknown option `--outter`; did you mean `--outer`?", or the parser's own words when all options
/// are known. @pre the parser of `app` has thrown `error`.
std::string what_is_wrong(CLI::App& app, const CLI::ParseError& error);

}  // namespace tetfarm
