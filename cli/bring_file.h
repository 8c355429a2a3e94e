/// Brings a file that a job starts from to the coordinator over the connection, for those who do
/// not see its store.
#pragma once

#include <cstdint>
#include <string>

#include "cli/coordinator_connection.h"
#include "cli/fetch_files.h"
#include "store/artifact_store.h"

namespace tetfarm {

/// The bytes, chunk by chunk; what the coordinator has of them already, also from another process
/// of the same user that was killed, is not sent again. `name` is shown.
/// @return what Submit names it by. @throws Error when the coordinator refuses (too large, no room)
/// or falls silent.
StoredArtifact bring_file(CoordinatorConnection& connection, const std::string& bytes,
                          const std::string& name, const FetchOptions& options);

}  // namespace tetfarm
