/// The command lines of what the program tells about itself: man, completion, version.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>

#include "cli/command_line.h"

namespace tetfarm {

/// What they read.
struct About {
  ManCommand man;
  CompletionCommand completion;
  VersionCommand version;
};

/// Adds them; `chosen` is called with the one that was given. @pre `about` outlives the app, which
/// has all other commands already.
void add_about(CLI::App& app, About& about, const std::function<void(const Command&)>& chosen);

}  // namespace tetfarm
