/// The command lines of the processes of a farm: coordinator, worker, and what a worker starts.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>

#include "cli/command_line.h"

namespace tetfarm {

/// What they read.
struct Services {
  CoordinatorCommand coordinator;
  WorkerCommand worker;
  TaskCommand task;
  TaskHostCommand task_host;
};

/// Adds them; `chosen` is called with the one that was given. @pre `services` outlives the app.
void add_services(CLI::App& app, Services& services,
                  const std::function<void(const Command&)>& chosen);

}  // namespace tetfarm
