/// The files of a job, from a store that this host sees.
#pragma once

#include <filesystem>
#include <vector>

#include "proto/messages.pb.h"
#include "store/artifact_store.h"

namespace tetfarm {

/// Links or copies the job's files (results, or evidence) from the store into `folder`, and says
/// where they are. @throws IoError.
std::vector<std::filesystem::path> deliver_files(const wire::JobStatus& status,
                                                 const std::filesystem::path& store,
                                                 const std::filesystem::path& folder);

/// Result files that were damaged since they were made; whether there were any. They are set aside,
/// so that the job makes them again. @throws IoError.
bool set_damaged_aside(const wire::JobStatus& status, const ArtifactStore& store);

}  // namespace tetfarm
