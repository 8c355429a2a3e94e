/// The answers to a viewer's questions as tables for people. With line ends.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "proto/messages.pb.h"

namespace tetfarm {

std::string jobs_text(const std::vector<wire::JobStatus>& jobs);
std::string tasks_text(const std::vector<wire::TaskLine>& tasks);
std::string workers_table(const std::vector<wire::WorkerLine>& workers);
std::string event_text(const wire::EventLine& event);
std::string log_text(const wire::AttemptLine& attempt);
std::string explanation_text(const wire::Explanation& explanation);

/// "2026-11-22 07:15:02", UTC; "" for 0.
std::string time_text(std::int64_t since_1970_ms);

}  // namespace tetfarm
