/// Options that several commands have in common: how to reach a coordinator, and as whom.
#pragma once

#include <CLI/CLI.hpp>

#include "cli/command_line.h"

namespace tetfarm {

void add_json(CLI::App& app, bool& json);
void add_keys_of_a_peer(CLI::App& app, KeyFiles& keys);

/// Of commands that talk to a coordinator: --connect is required.
void add_client(CLI::App& app, ClientOptions& client);
/// The same, and returns --connect, which is not required.
CLI::Option& add_connection(CLI::App& app, ClientOptions& client);

}  // namespace tetfarm
