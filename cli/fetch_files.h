/// Brings the files of a job over the connection, for those who do not see the store.
///
/// What has come of a file grows as `.CHECKSUM.part` in the folder, and gets the file's name when
/// all of it is there and is what its checksum says. Whoever is killed, loses the connection or the
/// coordinator goes on behind the last chunk that is there; a file that is whole is not fetched
/// again. Memory: the chunks that are under way.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "cli/coordinator_connection.h"
#include "cli/passing_file.h"
#include "cli/transfer_display.h"
#include "proto/messages.pb.h"

namespace tetfarm {

struct FetchOptions {
  std::int64_t timeout_ms = 10'000;  ///< without a chunk
  ProgressStyle progress = ProgressStyle::automatic;
};

/// The job's files (results, or evidence) into `folder`, and where they are.
/// @throws Error (out_of_resources) when there is no room, before anything is fetched; (not_found)
/// when the coordinator falls silent or does not have a file any more; CorruptFile when it has
/// other bytes; IoError.
std::vector<std::filesystem::path> fetch_files(CoordinatorConnection& connection,
                                               const wire::JobStatus& status,
                                               const std::filesystem::path& folder,
                                               const FetchOptions& options);

/// One of them into a file in `folder` that is gone with the process. @throws as fetch_files().
PassingFile fetch_for_a_while(CoordinatorConnection& connection, const wire::JobStatus& status,
                              const wire::Artifact& file, const std::filesystem::path& folder,
                              const FetchOptions& options);

}  // namespace tetfarm
