/// The options of the commands for meshes of the plane.
#pragma once

#include <CLI/CLI.hpp>

#include "cli/command_line.h"

namespace tetfarm {

/// Adds those of `plane`, `adapt` or `transfer` to its sub-command.
void add_plane(CLI::App& sub, PlaneCommand& plane);
void add_adapt(CLI::App& sub, AdaptCommand& adapt);
void add_plane_transfer(CLI::App& sub, PlaneTransferCommand& transfer);

}  // namespace tetfarm
