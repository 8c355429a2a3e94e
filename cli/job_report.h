/// What a job came to, as JSON for programs and as text for people.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "proto/messages.pb.h"

namespace tetfarm {

/// {"type":"result", …}: the last line of `run --json`. One line, no end.
std::string result_json(const wire::JobStatus& status, double seconds,
                        const std::vector<std::filesystem::path>& files);

/// {"type":"job", …} of one job of `status --json`.
std::string status_json(const wire::JobStatus& status);

/// {"type":"farm", …}: the first line of `status --json` of all jobs.
std::string farm_json(const wire::StatusReply& reply);

/// The same for a person, with line ends; angles that no solver likes in red.
std::string result_text(const wire::JobStatus& status, double seconds,
                        const std::vector<std::filesystem::path>& files, bool is_coloured = false);
std::string status_text(const wire::StatusReply& reply);

/// A line for each worker that is here.
std::string workers_text(const wire::StatusReply& reply);

/// Hosts in quarantine, and on demand the workers, as lines of JSON.
std::string farm_events_json(const wire::StatusReply& reply, bool with_workers);

/// {"type":what,"file":…}: what backup and restore say.
std::string copy_json(const std::string& what, const std::string& file);

/// {"type":"error","message":…,"exit_code":…}.
std::string error_json(const std::string& message, int exit_code);

/// Links or copies the job's files (results, or evidence) from the store into `folder`, and says
/// where they are. @throws IoError.
std::vector<std::filesystem::path> deliver_files(const wire::JobStatus& status,
                                                 const std::filesystem::path& store,
                                                 const std::filesystem::path& folder);

}  // namespace tetfarm
