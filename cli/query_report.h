/// The answers to a viewer's questions, as lines of JSON for programs and as tables for people.
/// The keys of JSON are documented in docs/operations.md and do not change.
#pragma once

#include <string>
#include <vector>

#include "proto/messages.pb.h"

namespace tetfarm {

// One object, one line, no end.
std::string job_json(const wire::JobStatus& job);
std::string task_json(const wire::TaskLine& task);
std::string worker_json(const wire::WorkerLine& worker);
std::string event_json(const wire::EventLine& event);
/// With "log" when `with_log`.
std::string attempt_json(const wire::AttemptLine& attempt, bool with_log);
std::string explanation_json(const wire::Explanation& explanation);

// With line ends.
std::string jobs_text(const std::vector<wire::JobStatus>& jobs);
std::string tasks_text(const std::vector<wire::TaskLine>& tasks);
std::string workers_table(const std::vector<wire::WorkerLine>& workers);
std::string event_text(const wire::EventLine& event);
std::string log_text(const wire::AttemptLine& attempt);
std::string explanation_text(const wire::Explanation& explanation);

/// "2026-11-22 07:15:02", UTC; "" for 0.
std::string time_text(std::int64_t since_1970_ms);

}  // namespace tetfarm
