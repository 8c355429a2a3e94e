/// The options of the command that draws.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "cli/command_line.h"

namespace tetfarm {

/// Adds those of `render` to its sub-command. `what_is_drawn`: of its help.
void add_render(CLI::App& sub, const std::string& what_is_drawn, RenderCommand& render);

}  // namespace tetfarm
