/// What a path below /api/ asks for. Plain functions on texts: no sockets, and nothing is looked
/// up.
///
/// The paths and what is answered to each are in docs/api.md.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace tetfarm {

enum class ApiSubject {
  about,
  farm,
  jobs,
  job,
  tasks,
  attempts,
  job_events,
  surfaces,
  surface,
  maps,
  map,
  task,
  task_logs,
  workers,
  events,
  changes,
  // what changes something
  cancel_job,
  retry_job,
  set_priority,
  retry_task,
  retry_host,
  drain_worker
};

struct ApiRequest {
  ApiSubject subject = ApiSubject::about;
  std::string job;                   ///< "job-7"; "": it is not about one
  std::uint64_t number = 0;          ///< of a task, a worker, a sub-domain or a map
  bool with_gone = false;            ///< workers that have left, too
  std::uint32_t last = 200;          ///< of events: so many, the newest
  std::vector<std::string> columns;  ///< of a table; empty: all
  std::uint64_t after = 0;           ///< rows of a table with higher numbers
  std::uint32_t limit = 20'000;      ///< rows of a page
  std::uint32_t triangles = 16'384;  ///< of a surface: at most so many, a power of two
  int priority = 0;                  ///< that a job is to have
  std::string host;                  ///< by its name; "": it is not about one
};

/// Why there is no answer: a status of HTTP, what is wrong, and what to do about it.
struct ApiError {
  int status = 400;
  std::string error;
  std::string help;
};

/// The most rows of a page, and the most events.
inline constexpr std::uint32_t most_rows = 20'000;
inline constexpr std::uint32_t most_events = 1'000;
/// The most triangles of a surface.
inline constexpr std::uint32_t most_shown_triangles = 131'072;

/// The highest priority of a job, and without its sign the lowest; store/rows.h has the same limit.
inline constexpr int highest_priority = 1'000;

/// Whether a path is one of ours: /api or below.
bool is_api_path(std::string_view target);
/// Whether it changes something.
bool is_act(ApiSubject subject);

/// @param method in capitals; HEAD is as GET
/// @param target path with what follows '?'; 404 for a path that is none, 405 for one that has
/// another method, 400 for parameters that are none or out of their bounds.
std::variant<ApiRequest, ApiError> parse_api_request(const std::string& method,
                                                     const std::string& target);

/// The paths as GET /api/v1 lists them: "GET /api/v1/jobs/JOB".
std::vector<std::string> api_paths();

}  // namespace tetfarm
