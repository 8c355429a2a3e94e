/// What several commands have in common: how they are declared, how to reach a coordinator, and as
/// whom.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>

#include "cli/command_line.h"

namespace tetfarm {

/// A sub-command with an example below its help. Its options live in `command`, which is what is
/// chosen with it.
template <class Options>
CLI::App& add_command(CLI::App& app, const std::string& name, const std::string& what,
                      const std::string& example, Options& command,
                      const std::function<void(const Command&)>& chosen) {
  CLI::App& sub = *app.add_subcommand(name, what);
  sub.footer("Example: " + example);
  sub.callback([&command, chosen] { chosen(command); });
  return sub;
}

void add_json(CLI::App& app, bool& json);
void add_keys_of_a_peer(CLI::App& app, KeyFiles& keys);

/// Of commands that talk to a coordinator: --connect is required.
void add_client(CLI::App& app, ClientOptions& client);
/// The same, and returns --connect, which is not required.
CLI::Option& add_connection(CLI::App& app, ClientOptions& client);

}  // namespace tetfarm
