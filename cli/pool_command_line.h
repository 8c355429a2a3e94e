/// The sub-command `tetfarm pool`.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>

#include "cli/command_line.h"

namespace tetfarm {

/// Adds it to `app`; what is read goes into `pool`, and then `chosen` is called.
void add_pool(CLI::App& app, PoolCommand& pool, const std::function<void()>& chosen);

}  // namespace tetfarm
