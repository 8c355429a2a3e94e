/// The formats of a job that its tasks do not write: converted from the VTKHDF file that came.
#pragma once

#include <filesystem>
#include <vector>

#include "cli/command_line.h"
#include "proto/messages.pb.h"

namespace tetfarm {

/// Where a format of a mesh NAME.vtkhdf goes, beside it: NAME.su2, NAME.msh22.msh; a format of
/// several files gets a folder of its own, NAME.openfoam. @throws UsageError for an unknown format.
std::filesystem::path converted_file(const std::filesystem::path& vtkhdf,
                                     const std::string& format);

/// Converts the mesh among `files` into what the job was asked for, and adds what was written. A
/// file or folder is there as a whole or not at all; one that is newer than the mesh is left alone.
/// Memory: one sub-domain. @throws IoError, Error when a format cannot hold the mesh.
void convert_mesh(const wire::JobStatus& status, ProgressStyle progress,
                  std::vector<std::filesystem::path>& files);

}  // namespace tetfarm
