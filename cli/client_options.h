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

/// Whether a command has --store: what lies there by default is told only where it can be named.
enum class StoreOption { no, yes };
void add_keys_of_a_peer(CLI::App& app, KeyFiles& keys, StoreOption store);

/// --connect, which is returned and not required, the keys, and how long to wait.
CLI::Option& add_peer(CLI::App& app, ClientOptions& client, StoreOption store);
/// Of commands that take a job as well as a file: where the job is.
void add_place_of_jobs(CLI::App& app, ViewOptions& view);

/// Of commands that talk to a coordinator: --connect is required.
void add_client(CLI::App& app, ClientOptions& client, StoreOption store);
/// The same, but --connect, which is returned, is not required.
CLI::Option& add_connection(CLI::App& app, ClientOptions& client, StoreOption store);

}  // namespace tetfarm
