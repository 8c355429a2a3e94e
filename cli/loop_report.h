/// What an adaptation loop came to, for people and as JSON.
#pragma once

#include <filesystem>
#include <vector>

#include "proto/messages.pb.h"

namespace tetfarm {

/// Whether the job is a loop that has ended well: it has counted its cycles.
bool is_of_loop(const wire::JobStatus& status);

/// Prints it: {"type":"loop", …}, or some lines that name the folder of the files, where there are
/// any. @pre is_of_loop(status).
void report_loop(const wire::JobStatus& status, const std::vector<std::filesystem::path>& files,
                 double seconds, bool json);

}  // namespace tetfarm
