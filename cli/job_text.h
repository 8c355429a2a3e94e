/// What jobs came to and how far they are, for people. With line ends.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "proto/messages.pb.h"

namespace tetfarm {

/// Of a finished job; angles that no solver likes in red.
std::string result_text(const wire::JobStatus& status, double seconds,
                        const std::vector<std::filesystem::path>& files, bool is_coloured = false);

std::string status_text(const wire::StatusReply& reply);

/// A line for each worker that is here.
std::string workers_text(const wire::StatusReply& reply);

}  // namespace tetfarm
