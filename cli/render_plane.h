/// The command that draws, for meshes of the plane: pictures, and charts of fields along patches.
#pragma once

#include <string>

#include "base/error.h"
#include "cli/command_line.h"

namespace tetfarm {

/// Whether the name is that of a file of the plane (.mesh).
bool is_plane_mesh_name(const std::string& file);

/// @throws UsageError for options that only a mesh of the plane has.
void require_no_plane_options(const RenderCommand& command);

/// @throws UsageError, InvalidInput, IoError.
ExitCode render_plane(const RenderCommand& command);

}  // namespace tetfarm
