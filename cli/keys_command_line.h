/// The sub-commands of `tetfarm keys`.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>

#include "cli/command_line.h"

namespace tetfarm {

/// Adds them to `app`; what is read goes into `keys`, and then `chosen` is called.
void add_keys(CLI::App& app, KeysCommand& keys, const std::function<void()>& chosen);

}  // namespace tetfarm
