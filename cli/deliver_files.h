/// The files of a job, from a store that this host sees.
#pragma once

#include <filesystem>
#include <vector>

#include "proto/messages.pb.h"

namespace tetfarm {

/// Links or copies the job's files (results, or evidence) from the store into `folder`, and says
/// where they are. @throws IoError.
std::vector<std::filesystem::path> deliver_files(const wire::JobStatus& status,
                                                 const std::filesystem::path& store,
                                                 const std::filesystem::path& folder);

}  // namespace tetfarm
